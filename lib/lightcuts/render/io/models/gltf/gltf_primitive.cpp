// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_primitive.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lightcuts {
namespace {

using gltf::Json;

class PrimitiveReader {
public:
  PrimitiveReader(const GltfFile& file, const Json& primitive)
      : file_(file), primitive_(primitive), attributes_(gltf::object_in(primitive, "attributes")) {}

  GltfPrimitive read(std::span<const double> weights, std::span<const std::size_t> uv_sets) {
    result_.material = gltf::index_in(primitive_, "material");
    result_.positions = vectors("POSITION", true);
    if (attributes_.contains("NORMAL")) result_.normals = vectors("NORMAL", true);
    morph(weights);
    if (attributes_.contains("COLOR_0")) read_colours();
    for (const std::size_t set : uv_sets) read_coordinates(set);
    read_skin();
    read_triangles();
    return std::move(result_);
  }

private:
  GltfElements elements(const Json& attributes, const char* name, std::size_t least,
                        std::size_t most) const {
    GltfElements read = read_elements(file_, gltf::whole_in(attributes, name), least, most);
    if (!result_.positions.empty() && read.count != result_.positions.size())
      throw GltfFault(
          fmt::format("{} {} for {} positions", read.count, name, result_.positions.size()));
    return read;
  }

  static std::vector<glm::vec3> as_vectors(const GltfElements& elements) {
    std::vector<glm::vec3> result(elements.count);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = elements.vec3(i);
    return result;
  }

  std::vector<glm::vec3> vectors(const char* name, bool check_compression) const {
    // Where only a compressed copy has the numbers, they would all be zeros.
    const Json& accessor = file_.item("accessors", gltf::whole_in(attributes_, name));
    if (check_compression && gltf::extension_of(primitive_, "KHR_draco_mesh_compression") &&
        !accessor.contains("bufferView") && !accessor.contains("sparse"))
      throw GltfFault("KHR_draco_mesh_compression is not supported");
    return as_vectors(elements(attributes_, name, 3, 3));
  }

  void morph(std::span<const double> weights) {
    const Json& targets = gltf::list_in(primitive_, "targets");
    for (std::size_t t = 0; t < std::min(targets.size(), weights.size()); ++t) {
      if (weights[t] == 0) continue;
      add(targets[t], "POSITION", weights[t], result_.positions);
      if (!result_.normals.empty()) add(targets[t], "NORMAL", weights[t], result_.normals);
    }
  }

  void add(const Json& target, const char* name, double weight, std::vector<glm::vec3>& to) const {
    if (!target.contains(name)) return;
    const GltfElements moved = elements(target, name, 3, 3);
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] = glm::vec3(glm::dvec3(to[i]) + weight * glm::dvec3(moved.vec3(i)));
  }

  void read_colours() {
    result_.colours = as_vectors(elements(attributes_, "COLOR_0", 3, 4));
    for (glm::vec3& colour : result_.colours)
      for (int c = 0; c < 3; ++c)
        if (!(colour[c] >= 0 && std::isfinite(colour[c])))
          throw GltfFault(fmt::format("a COLOR_0 of {}, expected 0 or more", colour[c]));
  }

  void read_coordinates(std::size_t set) {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (!attributes_.contains(name)) return;
    const GltfElements read = elements(attributes_, name.c_str(), 2, 2);
    std::vector<glm::vec2>& uv = result_.uv[set];
    uv.resize(read.count);
    for (std::size_t i = 0; i < uv.size(); ++i) uv[i] = read.vec2(i);
  }

  /// All sets side by side, as one of more numbers per vertex.
  void read_skin() {
    for (std::size_t set = 0; attributes_.contains(fmt::format("JOINTS_{}", set)); ++set) {
      append(elements(attributes_, fmt::format("JOINTS_{}", set).c_str(), 4, 4), result_.joints);
      append(elements(attributes_, fmt::format("WEIGHTS_{}", set).c_str(), 4, 4), result_.weights);
    }
  }

  static void append(const GltfElements& from, GltfElements& to) {
    if (to.count == 0) {
      to = from;
      return;
    }
    GltfElements both{from.count, to.width + from.width, {}};
    for (std::size_t i = 0; i < from.count; ++i) {
      const auto copy = [&](const GltfElements& part) {
        const auto begin = part.values.begin() + std::ptrdiff_t(i * part.width);
        both.values.insert(both.values.end(), begin, begin + std::ptrdiff_t(part.width));
      };
      copy(to);
      copy(from);
    }
    to = std::move(both);
  }

  void read_triangles() {
    std::vector<std::uint32_t> indices;
    if (const auto accessor = gltf::index_in(primitive_, "indices")) {
      indices = read_indices(file_, *accessor);
    } else {
      indices.resize(result_.positions.size());
      for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    }
    for (const std::uint32_t index : indices)
      if (index >= result_.positions.size())
        throw GltfFault(
            fmt::format("index {} is out of range: {} positions", index, result_.positions.size()));
    const std::size_t mode = gltf::whole_in(primitive_, "mode", 4), n = indices.size();
    auto& to = result_.triangles;
    if (mode == 4)
      for (std::size_t i = 0; i + 2 < n; i += 3)
        to.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    else if (mode == 5)
      for (std::size_t i = 0; i + 2 < n; ++i)
        to.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    else
      for (std::size_t i = 1; i + 1 < n; ++i)
        to.emplace_back(indices[i], indices[i + 1], indices[0]);
  }

  const GltfFile& file_;
  const Json &primitive_, &attributes_;
  GltfPrimitive result_;
};

} // namespace

std::optional<GltfPrimitive> read_primitive(const GltfFile& file, const Json& primitive,
                                            std::span<const double> weights,
                                            std::span<const std::size_t> uv_sets) {
  const std::size_t mode = gltf::whole_in(primitive, "mode", 4);
  if (mode > 6) throw GltfFault(fmt::format("a primitive's mode is {}", mode));
  if (mode < 4 || !gltf::object_in(primitive, "attributes").contains("POSITION"))
    return std::nullopt;
  return PrimitiveReader(file, primitive).read(weights, uv_sets);
}

} // namespace lightcuts
