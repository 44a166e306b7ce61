// SPDX-License-Identifier: MIT
// A glTF or, where it begins as one, a binary glTF, beside the files of tests/files/gltf.
#include <algorithm>
#include <cstdint>

#include <lightcuts/render/io/open_scene.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_json.h>

namespace lightcuts::fuzz {
namespace {

constexpr const char* magic = "glTF";
constexpr std::size_t header = 12, chunk_header = 8;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return word;
}

std::string word(std::size_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += char(number >> (8 * i) & 255);
  return bytes;
}

std::string chunk(const char (&type)[5], std::string content, char filling) {
  while (content.size() % 4 != 0) content += filling;
  return word(content.size()) + std::string(type, 4) + content;
}

/// The JSON and the bytes behind it, with lengths that are right.
std::string binary(const std::string& json, const std::string& bytes) {
  const std::string chunks = chunk("JSON", json, ' ') + chunk("BIN\0", bytes, '\0');
  return magic + word(2) + word(header + chunks.size()) + chunks;
}

std::string mutated_gltf(const std::string& input, gen::Dice& dice, const Bytewise& bytewise) {
  if (!input.starts_with(magic)) {
    const std::string text = mutated_json(input, dice, bytewise);
    return dice.one_in(16) ? binary(text, std::string(120, '\1')) : text;
  }
  if (input.size() < header + chunk_header) return bytewise(input);
  const std::size_t begin = header + chunk_header;
  const std::size_t length = std::min<std::size_t>(word_at(input, header), input.size() - begin);
  std::string json = input.substr(begin, length), bytes;
  if (input.size() >= begin + length + chunk_header)
    bytes = input.substr(begin + length + chunk_header);
  if (dice.one_in(4))
    bytes = bytewise(bytes);
  else
    json = mutated_json(json, dice, bytewise);
  return binary(json, bytes);
}

void run_gltf(Bytes input) {
  static const WorkFolder folder("gltf");
  const std::string content = text_of(input);
  const auto file = folder.put(content.starts_with(magic) ? "fuzzed.glb" : "fuzzed.gltf", content);
  read_or_refused(folder.name(), [&] { require_valid(open_scene(file.string())); });
}

const Registered gltf({"gltf", run_gltf, mutated_gltf});

} // namespace
} // namespace lightcuts::fuzz
