// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/model_textures.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/texture_decoding.h>

namespace lightcuts {
namespace {

/// The file meant: as named, or as a URI, or with a path from Windows.
std::filesystem::path find_file(const std::filesystem::path& folder, const std::string& name,
                                bool is_uri) {
  if (name.empty()) throw InputError(InputFault::missing, "no image in it");
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  std::error_code error; // a name that is too long, say: no such file
  for (const std::string& spelling : {name, is_uri ? percent_decoded(name) : slashes})
    if (spelling.find('\0') == std::string::npos &&
        std::filesystem::is_regular_file(folder / spelling, error))
      return folder / spelling;
  throw InputError(InputFault::unreadable_file, "no such file");
}

} // namespace

std::string percent_decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char code = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

template <class Read>
ModelTextures::Index ModelTextures::once(const std::string& key, const std::string& title,
                                         const Read& read) {
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  Index& index = known_[key];
  try {
    scene_.textures.push_back(read());
  } catch (const InputError& error) {
    note_once(fmt::format("{} cannot be read: {}: the factor colour is used", title, error.what()));
    return index;
  }
  const std::size_t clamped = scene_.textures.back().clamped();
  if (clamped > 0)
    note_once(
        fmt::format("{} {} negative or not finite: clamped", title, counted(clamped, "texel")));
  return index = static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

ModelTextures::Index ModelTextures::of_file(const std::string& name, bool is_uri) {
  const std::string key = "file " + std::filesystem::path(name).lexically_normal().string();
  return once(key, fmt::format("texture '{}'", name), [&] {
    const std::filesystem::path file = find_file(model_.parent_path(), name, is_uri);
    if (!access_.allows(file))
      throw InputError(InputFault::unreadable_file,
                       "outside the scene's folder; --allow-outside allows it");
    return decode_texture(read_file(file), name);
  });
}

ModelTextures::Index ModelTextures::embedded(std::size_t number, std::string_view bytes,
                                             const std::string& extension) {
  return once(fmt::format("embedded {}", number), fmt::format("embedded texture {}", number),
              [&] { return decode_texture(bytes, "texture." + extension); });
}

void ModelTextures::note_once(const std::string& text) {
  const std::string note = one_line(fmt::format("{}: {}", model_.string(), text));
  if (notes_.insert(note).second) scene_.notes.push_back(note);
}

} // namespace lightcuts
