// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_file.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/json/json_text.h>
#include <lightcuts/render/io/models/model_textures.h>

namespace lightcuts {
namespace {

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return word;
}

struct GlbChunks {
  std::string json, binary;
};

/// A binary glTF: 12 bytes of header, then chunks: length, type, content.
GlbChunks chunks_of(const std::string& file, const std::string& bytes) {
  if (bytes.size() < 20 || bytes.compare(0, 4, "glTF") != 0)
    throw InputError(InputFault::malformed_file, fmt::format("{}: not a binary glTF file", file));
  const std::size_t total = word_at(bytes, 8), length = word_at(bytes, 12);
  if (total > bytes.size() || length > bytes.size() - 20)
    throw InputError(InputFault::malformed_file,
                     fmt::format("{}: truncated: {} bytes of {}", file, bytes.size(),
                                 std::max(total, length + 20)));
  GlbChunks chunks{bytes.substr(20, length), {}};
  for (std::size_t at = 20 + length; at + 8 <= bytes.size();) {
    const std::size_t size = word_at(bytes, at);
    if (size > bytes.size() - at - 8)
      throw InputError(InputFault::malformed_file,
                       fmt::format("{}: truncated: a chunk of {} bytes", file, size));
    if (bytes.compare(at + 4, 4, std::string("BIN\0", 4)) == 0) {
      chunks.binary = bytes.substr(at + 8, size);
      break;
    }
    at += 8 + size;
  }
  return chunks;
}

/// The value of a character of base64, also of the kind for URLs; -1 of any other.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::string from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) throw GltfFault("a data URI that is not base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

void check_version(const std::string& file, const gltf::Json& root) {
  const gltf::Json& asset = root.at("asset");
  const std::string least = gltf::text_in(asset, "minVersion", "2.0");
  if (asset.at("version").get<std::string>().rfind("2.", 0) != 0 || least != "2.0")
    throw InputError(InputFault::unsupported, fmt::format("{}: not glTF 2.0", file));
}

} // namespace

DataUri read_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw GltfFault("a data URI without data");
  std::string_view head = uri.substr(5, comma - 5);
  if (!head.ends_with(";base64")) throw GltfFault("a data URI that is not base64");
  head = head.substr(0, head.find(';'));
  return {std::string(head), from_base64(uri.substr(comma + 1))};
}

GltfFile::GltfFile(const std::filesystem::path& file, const FileAccess& access) : path_(file) {
  const std::string name = file.string();
  std::string binary;
  if (lower_extension(file) == ".glb") {
    GlbChunks chunks = chunks_of(name, read_file(file));
    root_ = parse_json(name, chunks.json);
    binary = std::move(chunks.binary);
  } else {
    root_ = parse_json(name, read_text(file));
  }
  if (!root_.is_object()) throw GltfFault("not an object");
  check_version(name, root_);
  read_buffers(access, std::move(binary));
}

void GltfFile::read_buffers(const FileAccess& access, std::string chunk) {
  for (const gltf::Json& buffer : gltf::list_in(root_, "buffers")) {
    const std::string uri = gltf::text_in(buffer, "uri", "");
    const std::size_t expected = gltf::whole_in(buffer, "byteLength");
    if (uri.empty()) { // the file's own chunk; else there is nothing that could be used
      buffers_.push_back(buffers_.empty() ? std::move(chunk) : std::string());
      if (buffers_.back().empty()) continue;
    } else {
      buffers_.push_back(bytes_of(uri, "buffer", access));
    }
    if (buffers_.back().size() < expected)
      throw InputError(
          InputFault::malformed_file,
          one_line(fmt::format("{}: its buffer '{}' is truncated: {} bytes of {}", path_.string(),
                               is_data_uri(uri) ? "data:"
                               : uri.empty()    ? "chunk"
                                                : uri,
                               buffers_.back().size(), expected)));
    buffers_.back().resize(expected);
  }
}

std::string GltfFile::bytes_of(const std::string& uri, const char* what,
                               const FileAccess& access) const {
  if (is_data_uri(uri)) return read_data_uri(uri).bytes;
  for (const std::string& spelling : {uri, percent_decoded(uri)}) {
    const std::filesystem::path file = path_.parent_path() / spelling;
    std::error_code error;
    if (spelling.find('\0') != std::string::npos || !std::filesystem::exists(file, error)) continue;
    access.require(file, fmt::format("{}: its {} '{}'", path_.string(), what, uri));
    return read_file(file);
  }
  throw InputError(InputFault::unreadable_file,
                   one_line(fmt::format("{}: cannot open its {} '{}'", path_.string(), what, uri)));
}

const gltf::Json& GltfFile::item(const char* list, std::size_t index) const {
  const gltf::Json& items = gltf::list_in(root_, list);
  if (index >= items.size()) throw GltfFault(fmt::format("{} of {} is not there", list, index));
  return items[index];
}

std::string GltfFile::name_of(const char* list, const char* kind, std::size_t index) const {
  return gltf::text_in(item(list, index), "name", fmt::format("{} {}", kind, index));
}

std::string_view GltfFile::view(std::size_t index) const {
  const gltf::Json& view = item("bufferViews", index);
  const std::size_t buffer = gltf::whole_in(view, "buffer");
  const std::size_t offset = gltf::whole_in(view, "byteOffset", 0);
  const std::size_t length = gltf::whole_in(view, "byteLength");
  const std::size_t size = buffer < buffers_.size() ? buffers_[buffer].size() : 0;
  if (offset > size || length > size - offset)
    throw GltfFault(fmt::format("bufferView {} exceeds its buffer of {} bytes", index, size));
  return std::string_view(buffers_[buffer]).substr(offset, length);
}

} // namespace lightcuts
