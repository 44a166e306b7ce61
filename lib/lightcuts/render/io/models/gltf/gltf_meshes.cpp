// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_meshes.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/models/gltf/gltf_primitive.h>
#include <lightcuts/render/io/models/mesh_builder.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

using gltf::Json;

/// Where a skin's joints put what hangs on each of them alone.
std::vector<glm::dmat4> joint_transforms(const GltfFile& file, const GltfNodes& nodes,
                                         std::size_t skin) {
  const Json& source = file.item("skins", skin);
  std::vector<glm::dmat4> joints;
  for (const Json& joint : gltf::list_in(source, "joints")) {
    const std::size_t node = gltf::whole(joint, "joints");
    if (node >= nodes.world.size()) throw GltfFault(fmt::format("joint {} is not there", node));
    joints.push_back(nodes.world[node]);
  }
  const auto inverse = gltf::index_in(source, "inverseBindMatrices");
  if (!inverse) return joints; // identities
  const GltfElements matrices = read_elements(file, *inverse, 16, 16);
  if (matrices.count < joints.size())
    throw GltfFault(
        fmt::format("{} inverseBindMatrices for {} joints", matrices.count, joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    glm::dmat4 m(1);
    for (int k = 0; k < 16; ++k) m[k / 4][k % 4] = matrices.values[16 * i + std::size_t(k)];
    joints[i] *= m;
  }
  return joints;
}

/// The transforms of EXT_mesh_gpu_instancing within the node; one, the identity, without.
std::vector<glm::dmat4> instances_of(const GltfFile& file, const Json& node) {
  const Json* extension = gltf::extension_of(node, "EXT_mesh_gpu_instancing");
  if (!extension) return {glm::dmat4(1)};
  const Json& attributes = gltf::object_in(*extension, "attributes");
  std::size_t count = 0;
  const auto read = [&](const char* name, std::size_t width) {
    if (!attributes.contains(name)) return GltfElements();
    GltfElements elements = read_elements(file, gltf::whole_in(attributes, name), width, width);
    if (count != 0 && elements.count != count)
      throw GltfFault(fmt::format("{} {} for {} instances", elements.count, name, count));
    count = elements.count;
    return elements;
  };
  const GltfElements translation = read("TRANSLATION", 3), rotation = read("ROTATION", 4),
                     scale = read("SCALE", 3);
  std::vector<glm::dmat4> transforms(count);
  for (std::size_t i = 0; i < count; ++i)
    transforms[i] =
        transform_of(translation.count ? glm::dvec3(translation.vec3(i)) : glm::dvec3(0),
                     rotation.count ? glm::dvec4(rotation.vec4(i)) : glm::dvec4(0, 0, 0, 1),
                     scale.count ? glm::dvec3(scale.vec3(i)) : glm::dvec3(1));
  return transforms;
}

std::vector<double> morph_weights(const Json& node, const Json& mesh) {
  std::vector<double> weights;
  for (const Json& weight : gltf::list_in(node.contains("weights") ? node : mesh, "weights"))
    weights.push_back(weight.get<double>());
  return weights;
}

/// A vertex's transform, and that of its normal: the inverse transposed times a positive number,
/// which also a transform without an inverse has.
struct Placement {
  explicit Placement(const glm::dmat4& transform)
      : position(transform), normal(cofactors(glm::dmat3(transform))),
        mirrored(glm::determinant(glm::dmat3(transform)) < 0) {
    if (mirrored) normal = -normal;
  }
  static glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
  }

  glm::dmat4 position;
  glm::dmat3 normal;
  bool mirrored;
};

class MeshCollector {
public:
  MeshCollector(const GltfFile& file, const GltfNodes& nodes, GltfMaterials& materials,
                Scene& scene)
      : file_(file), nodes_(nodes), materials_(materials), scene_(scene),
        mesh_(file.path().string(), scene) {}

  void collect() {
    for (const GltfMeshNode& node : nodes_.meshes) add_node(node);
    mesh_.finish();
    const auto note = [&](std::size_t count, const std::string& text) {
      if (count > 0) scene_.notes.push_back(fmt::format("{}: {}", file_.path().string(), text));
    };
    note(without_uv_, "a texture without texture coordinates on " +
                          counted(without_uv_, "mesh part") + ": the factor colour is used");
    note(no_triangles_, counted(no_triangles_, "mesh part") + " of points or lines left out");
  }

private:
  void add_node(const GltfMeshNode& mesh_node) {
    const Json& node = file_.item("nodes", mesh_node.node);
    const Json& mesh = file_.item("meshes", mesh_node.mesh);
    name_ = file_.name_of("meshes", "mesh", mesh_node.mesh);
    const std::vector<double> weights = morph_weights(node, mesh);
    std::vector<Placement> placements;
    for (const glm::dmat4& instance : instances_of(file_, node))
      placements.emplace_back(nodes_.world[mesh_node.node] * instance);
    joints_.clear();
    if (mesh_node.skin) joints_ = joint_transforms(file_, nodes_, *mesh_node.skin);
    for (const Json& primitive : gltf::list_in(mesh, "primitives"))
      add_primitive(primitive, weights, placements);
  }

  void add_primitive(const Json& source, const std::vector<double>& weights,
                     const std::vector<Placement>& placements) {
    const GltfMaterial& material = materials_.material(gltf::index_in(source, "material"));
    std::vector<std::size_t> sets;
    if (material.base) sets.push_back(material.base->uv_set);
    if (material.emission) sets.push_back(material.emission->uv_set);
    const auto primitive = read_primitive(file_, source, weights, sets);
    if (!primitive) {
      ++no_triangles_;
      return;
    }
    const Textured textured(material, *primitive);
    if (textured.lacks_coordinates(material)) ++without_uv_;
    const std::uint32_t surface =
        materials_.surface(primitive->material, textured.base, textured.emission);
    if (!joints_.empty() && primitive->joints.count > 0)
      return add_skinned(*primitive, textured, surface, placements);
    for (const Placement& placement : placements)
      add(*primitive, textured, surface,
          [&](std::size_t) -> const Placement& { return placement; });
  }

  /// What of a primitive a material's textures are looked up with; nothing where it is not there.
  struct Textured {
    Textured(const GltfMaterial& material, const GltfPrimitive& primitive)
        : base(coordinates(material.base, primitive)),
          emission(coordinates(material.emission, primitive)) {
      if (base) base_texture = &*material.base;
      if (emission) emission_texture = &*material.emission;
    }
    [[nodiscard]] bool lacks_coordinates(const GltfMaterial& material) const {
      return (material.base && !base) || (material.emission && !emission);
    }
    static const std::vector<glm::vec2>* coordinates(const std::optional<GltfTexture>& texture,
                                                     const GltfPrimitive& primitive) {
      if (!texture) return nullptr;
      const auto found = primitive.uv.find(texture->uv_set);
      return found == primitive.uv.end() ? nullptr : &found->second;
    }
    const std::vector<glm::vec2>*base, *emission;
    const GltfTexture *base_texture = nullptr, *emission_texture = nullptr;
  };

  /// A skin's node does not count: its joints say where the vertices are.
  void add_skinned(const GltfPrimitive& primitive, const Textured& textured, std::uint32_t surface,
                   const std::vector<Placement>& placements) {
    std::vector<Placement> places;
    places.reserve(primitive.positions.size());
    for (std::size_t i = 0; i < primitive.positions.size(); ++i)
      places.push_back(skinned(primitive, i, placements));
    add(primitive, textured, surface, [&](std::size_t i) -> const Placement& { return places[i]; });
  }

  [[nodiscard]] Placement skinned(const GltfPrimitive& primitive, std::size_t vertex,
                                  const std::vector<Placement>& placements) const {
    glm::dmat4 sum(0);
    double total = 0;
    for (std::size_t k = 0; k < primitive.joints.width; ++k) {
      const double weight = primitive.weights.values[vertex * primitive.weights.width + k];
      if (weight == 0) continue;
      const double joint = primitive.joints.values[vertex * primitive.joints.width + k];
      if (!(joint >= 0 && joint < static_cast<double>(joints_.size())))
        throw GltfFault(fmt::format("joint {} of {}", joint, joints_.size()));
      sum += weight * joints_[static_cast<std::size_t>(joint)];
      total += weight;
    }
    // Weights of integers need not sum to 1 exactly.
    if (total > 0) return Placement(sum / total);
    return placements.empty() ? Placement(glm::dmat4(1)) : placements[0];
  }

  template <class PlacementOf>
  void add(const GltfPrimitive& primitive, const Textured& textured, std::uint32_t surface,
           const PlacementOf& placement_of) {
    std::vector<std::uint32_t> indices(primitive.positions.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = mesh_.add(vertex(primitive, textured, i, placement_of(i)));
    for (const glm::uvec3& t : primitive.triangles) {
      glm::uvec3 corners(indices[t.x], indices[t.y], indices[t.z]);
      if (placement_of(t.x).mirrored) std::swap(corners.y, corners.z);
      mesh_.add_triangle(corners, surface);
    }
  }

  [[nodiscard]] MeshVertex vertex(const GltfPrimitive& primitive, const Textured& textured,
                                  std::size_t i, const Placement& place) const {
    MeshVertex result;
    result.position = glm::vec3(glm::dvec3(place.position * glm::dvec4(primitive.positions[i], 1)));
    if (!is_finite(result.position))
      throw InputError(InputFault::not_finite,
                       one_line(fmt::format("{}: mesh '{}': vertex {} is not finite",
                                            file_.path().string(), name_, i)));
    if (!primitive.normals.empty())
      result.normal = unit_or_zero(place.normal * glm::dvec3(primitive.normals[i]));
    if (textured.base) result.uv = coordinates(*textured.base_texture, *textured.base, i);
    if (textured.emission)
      result.emission_uv = coordinates(*textured.emission_texture, *textured.emission, i);
    if (!primitive.colours.empty()) result.colour = primitive.colours[i];
    return result;
  }

  [[nodiscard]] glm::vec2 coordinates(const GltfTexture& texture, const std::vector<glm::vec2>& all,
                                      std::size_t i) const {
    const glm::vec2 uv = texture.at(all[i]);
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
      throw InputError(InputFault::not_finite,
                       one_line(fmt::format("{}: mesh '{}': texture coordinate {} is not finite",
                                            file_.path().string(), name_, i)));
    return uv;
  }

  const GltfFile& file_;
  const GltfNodes& nodes_;
  GltfMaterials& materials_;
  Scene& scene_;
  MeshBuilder mesh_;
  std::string name_;
  std::vector<glm::dmat4> joints_;
  std::size_t without_uv_ = 0, no_triangles_ = 0;
};

} // namespace

void append_meshes(const GltfFile& file, const GltfNodes& nodes, GltfMaterials& materials,
                   Scene& scene) {
  MeshCollector(file, nodes, materials, scene).collect();
}

} // namespace lightcuts
