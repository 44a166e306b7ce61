// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_textures.h>

#include <cmath>

#include <fmt/format.h>

namespace lightcuts {
namespace {

Wrap wrap_of(std::size_t code) {
  if (code == 33071) return Wrap::clamp;
  if (code == 33648) return Wrap::mirror;
  return Wrap::repeat;
}

/// The image of a texture, or of the WebP that may take its place.
std::optional<std::size_t> source_of(const gltf::Json& texture) {
  if (const auto source = gltf::index_in(texture, "source")) return source;
  const gltf::Json* webp = gltf::extension_of(texture, "EXT_texture_webp");
  return webp ? gltf::index_in(*webp, "source") : std::nullopt;
}

/// "png" of "image/png"; some write the former.
std::string extension_of_type(const std::string& type) {
  return type.substr(type.rfind('/') + 1); // npos + 1 is 0
}

} // namespace

glm::vec2 GltfTexture::at(const glm::vec2& uv) const {
  const glm::dvec2 scaled = scale * glm::dvec2(uv);
  const double c = std::cos(rotation), s = std::sin(rotation);
  // v runs downwards: counter-clockwise is from +u to -v.
  const glm::dvec2 turned =
      rotation == 0 ? scaled : glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
  const glm::dvec2 placed = turned + offset;
  return {static_cast<float>(placed.x), static_cast<float>(1 - placed.y)};
}

std::optional<GltfTexture> GltfTextures::in(const gltf::Json& object, const char* key) {
  if (!object.contains(key)) return std::nullopt;
  const gltf::Json& info = gltf::object_in(object, key);
  const std::size_t index = gltf::whole_in(info, "index");
  const gltf::Json& texture = file_.item("textures", index);
  const auto source = source_of(texture);
  if (!source) {
    note_once(
        fmt::format("texture {} has no image that can be read: the factor colour is used", index));
    return std::nullopt;
  }
  const ModelTextures::Index read = image(*source);
  if (!read) return std::nullopt;
  GltfTexture result;
  result.texture.index = *read;
  if (const auto sampler = gltf::index_in(texture, "sampler")) {
    const gltf::Json& how = file_.item("samplers", *sampler);
    result.texture.wrap = {wrap_of(gltf::whole_in(how, "wrapS", 10497)),
                           wrap_of(gltf::whole_in(how, "wrapT", 10497))};
  }
  result.uv_set = gltf::whole_in(info, "texCoord", 0);
  if (const gltf::Json* transform = gltf::extension_of(info, "KHR_texture_transform")) {
    result.uv_set = gltf::whole_in(*transform, "texCoord", result.uv_set);
    result.scale = gltf::vector_in(*transform, "scale", glm::dvec2(1));
    result.offset = gltf::vector_in(*transform, "offset", glm::dvec2(0));
    result.rotation = gltf::number_in(*transform, "rotation", 0);
  }
  return result;
}

ModelTextures::Index GltfTextures::image(std::size_t index) {
  const gltf::Json& image = file_.item("images", index);
  const std::string type = gltf::text_in(image, "mimeType", "");
  if (const auto view = gltf::index_in(image, "bufferView"))
    return textures_.embedded(index, file_.view(*view), extension_of_type(type));
  const std::string uri = gltf::text_in(image, "uri", "");
  if (!is_data_uri(uri)) return textures_.of_file(uri, true);
  const DataUri data = read_data_uri(uri);
  return textures_.embedded(index, data.bytes,
                            extension_of_type(data.type.empty() ? type : data.type));
}

} // namespace lightcuts
