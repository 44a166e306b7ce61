// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/imported_texture.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/texture_decoding.h>

namespace lightcuts {
namespace {

Wrap wrap_of(aiTextureMapMode mode) {
  if (mode == aiTextureMapMode_Clamp) return Wrap::clamp;
  if (mode == aiTextureMapMode_Mirror) return Wrap::mirror;
  return Wrap::repeat;
}

/// A URI's %20 and the like as characters.
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

/// The file meant: as named, or as a URI, or with a path from Windows.
std::filesystem::path find_file(const std::filesystem::path& folder, const std::string& name,
                                bool is_uri) {
  if (name.empty()) throw InputError(InputFault::missing, "no image in it");
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  std::error_code error; // a name that is too long, say: no such file
  for (const std::string& spelling : {name, is_uri ? percent_decoded(name) : slashes})
    if (std::filesystem::is_regular_file(folder / spelling, error)) return folder / spelling;
  throw InputError(InputFault::unreadable_file, "no such file");
}

bool is_embedded(const std::string& name) { return name.starts_with('*'); }

/// The image behind Assimp's "*7".
const aiTexture& embedded(const aiScene& source, const std::string& name) {
  unsigned index = 0;
  std::from_chars(name.data() + 1, name.data() + name.size(), index);
  if (index >= source.mNumTextures || source.mTextures[index]->mHeight != 0)
    throw InputError(InputFault::missing,
                     "not in the file"); // a height would mean pixels, which no glTF file has
  return *source.mTextures[index];
}

} // namespace

std::optional<ImportedTexture> TextureImport::of(const aiMaterial& material) {
  const aiTextureType type = is_gltf_ ? aiTextureType_BASE_COLOR : aiTextureType_DIFFUSE;
  if (material.GetTextureCount(type) == 0) return note_unused(material), std::nullopt;
  aiString name;
  unsigned uv_set = 0;
  std::array<aiTextureMapMode, 2> modes{aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  material.GetTexture(type, 0, &name, nullptr, &uv_set, nullptr, nullptr, modes.data());
  const Index index = index_of(name.C_Str());
  if (!index) return std::nullopt;
  ImportedTexture texture{
      *index, {wrap_of(modes[0]), wrap_of(modes[1])}, uv_set, glm::vec2(1), glm::vec2(0)};
  aiUVTransform transform;
  if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == AI_SUCCESS)
    apply_transform(transform, name.C_Str(), texture);
  return texture;
}

/// glTF's older kind of material, specular-glossiness, has its texture elsewhere.
void TextureImport::note_unused(const aiMaterial& material) {
  aiString name;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &name) == AI_SUCCESS)
    note_once(name.C_Str(), "of a specular-glossiness material left out");
}

/// Assimp turns about the image's centre: without a rotation its offset is ours.
void TextureImport::apply_transform(const aiUVTransform& transform, const std::string& name,
                                    ImportedTexture& texture) {
  if (transform.mRotation != 0)
    return note_once(name, "is used without its transform: rotations are not supported");
  texture.scale = {transform.mScaling.x, transform.mScaling.y};
  texture.offset = {transform.mTranslation.x, transform.mTranslation.y};
}

TextureImport::Index TextureImport::index_of(const std::string& name) {
  const std::string key = std::filesystem::path(name).lexically_normal().string();
  const auto found = known_.find(key);
  return found != known_.end() ? found->second : known_[key] = add(name);
}

TextureImport::Index TextureImport::add(const std::string& name) {
  try {
    scene_.textures.push_back(read(name));
  } catch (const InputError& error) {
    note_once(name, fmt::format("cannot be read: {}: the factor colour is used", error.what()));
    return std::nullopt;
  }
  const std::size_t clamped = scene_.textures.back().clamped();
  if (clamped > 0) note_once(name, counted(clamped, "texel") + " negative or not finite: clamped");
  return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

Texture TextureImport::read(const std::string& name) const {
  if (!is_embedded(name))
    return decode_texture(read_file(find_file(model_.parent_path(), name, is_gltf_)), name);
  const aiTexture& image = embedded(source_, name);
  // mWidth is the size in bytes, the hint an extension ("png").
  return decode_texture({reinterpret_cast<const char*>(image.pcData), image.mWidth},
                        std::string("texture.") + image.achFormatHint);
}

void TextureImport::note_once(const std::string& name, const std::string& text) {
  const std::string title = is_embedded(name) ? fmt::format("embedded texture {}", name.substr(1))
                                              : fmt::format("texture '{}'", name);
  const std::string note = one_line(fmt::format("{}: {} {}", model_.string(), title, text));
  if (notes_.insert(note).second) scene_.notes.push_back(note);
}

} // namespace lightcuts
