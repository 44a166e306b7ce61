// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/model_import.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat4x4.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/models/gltf_nodes.h>
#include <lightcuts/render/io/models/imported_material.h>
#include <lightcuts/render/io/models/imported_texture.h>
#include <lightcuts/render/io/models/obj_check.h>
#include <lightcuts/render/scene/framing.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

glm::dmat4 matrix_of(const aiMatrix4x4& m) { // Assimp's rows are GLM's columns
  return {{m.a1, m.b1, m.c1, m.d1},
          {m.a2, m.b2, m.c2, m.d2},
          {m.a3, m.b3, m.c3, m.d3},
          {m.a4, m.b4, m.c4, m.d4}};
}

/// Copies Assimp's scene into ours, node by node.
class Collector {
public:
  Collector(const std::filesystem::path& file, bool is_gltf, const aiScene& source, Scene& scene)
      : file_(file.string()), is_gltf_(is_gltf), source_(source), scene_(scene),
        textures_(file, is_gltf, source, scene), surfaces_of_material_(source.mNumMaterials) {}

  void collect() {
    const std::size_t before = scene_.mesh.triangles.size();
    visit(*source_.mRootNode, glm::dmat4(1));
    if (scene_.mesh.triangles.size() == before)
      throw InputError(InputFault::missing, fmt::format("{}: no triangles", file_));
    if (!scene_.mesh.uv.empty()) resize_uv(scene_.mesh.positions.size());
    add_notes();
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// A material is one surface, or two where only some of its meshes can have its texture.
  struct Surfaces {
    std::uint32_t plain = none, textured = none;
  };

  void visit(const aiNode& node, const glm::dmat4& parent) {
    const glm::dmat4 world = parent * matrix_of(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*source_.mMeshes[node.mMeshes[i]], world);
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], world);
  }

  void add_mesh(const aiMesh& mesh, const glm::dmat4& world) {
    if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) return;
    const auto first = static_cast<std::uint32_t>(scene_.mesh.positions.size());
    add_vertices(mesh, world);
    const bool mirrored = glm::determinant(glm::dmat3(world)) < 0;
    const std::uint32_t surface = surface_for(mesh.mMaterialIndex, add_texture(mesh, first));
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
      if (mesh.mFaces[i].mNumIndices == 3)
        add_triangle(mesh, mesh.mFaces[i], first, surface, mirrored);
  }

  void add_vertices(const aiMesh& mesh, const glm::dmat4& world) {
    const glm::dmat3 normals = glm::inverseTranspose(glm::dmat3(world));
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const glm::vec3 position(glm::dvec3(world * glm::dvec4(v.x, v.y, v.z, 1)));
      if (!is_finite(position))
        throw InputError(
            InputFault::not_finite,
            fmt::format("{}: mesh '{}': vertex {} is not finite", file_, mesh.mName.C_Str(), i));
      scene_.mesh.positions.push_back(position);
      scene_.mesh.normals.push_back(mesh.HasNormals() ? unit(normals, mesh.mNormals[i])
                                                      : glm::vec3(0));
    }
  }

  /// The texture of the mesh's material, if the mesh has coordinates for it, which are added.
  std::optional<ImportedTexture> add_texture(const aiMesh& mesh, std::uint32_t first) {
    const auto texture = textures_.of(*source_.mMaterials[mesh.mMaterialIndex]);
    if (!texture) return std::nullopt;
    if (!mesh.HasTextureCoords(texture->uv_set)) {
      ++without_uv_;
      return std::nullopt;
    }
    resize_uv(first);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mTextureCoords[texture->uv_set][i];
      const glm::vec2 uv = texture->scale * glm::vec2(v.x, v.y) + texture->offset;
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
        throw InputError(InputFault::not_finite,
                         fmt::format("{}: mesh '{}': texture coordinate {} is not finite", file_,
                                     mesh.mName.C_Str(), i));
      scene_.mesh.uv.push_back(uv);
    }
    return texture;
  }

  void resize_uv(std::size_t count) { scene_.mesh.uv.resize(count, glm::vec2(0)); }

  /// Zero, which stands for the face's normal, where there is no direction.
  static glm::vec3 unit(const glm::dmat3& normals, const aiVector3D& n) {
    const glm::vec3 result(glm::normalize(normals * glm::dvec3(n.x, n.y, n.z)));
    return is_finite(result) ? result : glm::vec3(0);
  }

  void add_triangle(const aiMesh& mesh, const aiFace& face, std::uint32_t first,
                    std::uint32_t surface, bool mirrored) {
    glm::uvec3 triangle;
    for (int corner = 0; corner < 3; ++corner) {
      if (face.mIndices[corner] >= mesh.mNumVertices)
        throw InputError(InputFault::malformed_file,
                         fmt::format("{}: mesh '{}': index {} is out of range", file_,
                                     mesh.mName.C_Str(), face.mIndices[corner]));
      triangle[corner] = first + face.mIndices[corner];
    }
    if (mirrored) std::swap(triangle.y, triangle.z);
    if (!has_area(triangle)) {
      ++without_area_;
      return;
    }
    scene_.mesh.triangles.push_back(triangle);
    scene_.mesh.surface.push_back(surface);
  }

  [[nodiscard]] bool has_area(const glm::uvec3& triangle) const {
    const glm::dvec3 a(scene_.mesh.positions[triangle.x]);
    const glm::dvec3 cross = glm::cross(glm::dvec3(scene_.mesh.positions[triangle.y]) - a,
                                        glm::dvec3(scene_.mesh.positions[triangle.z]) - a);
    return cross != glm::dvec3(0);
  }

  /// Materials that nothing uses would say that the scene needs what it does not.
  std::uint32_t surface_for(unsigned material, const std::optional<ImportedTexture>& texture) {
    Surfaces& known = surfaces_of_material_[material];
    const aiMaterial& source = *source_.mMaterials[material];
    if (known.plain == none && known.textured == none) count_transparent(source);
    std::uint32_t& index = texture ? known.textured : known.plain;
    if (index != none) return index;
    const std::string where = fmt::format("{}: material '{}'", file_, source.GetName().C_Str());
    scene_.surfaces.push_back(surface_of(source, is_gltf_, where, scene_.notes));
    if (texture)
      scene_.surfaces.back().texture = {texture->index, texture->wrap, tinted_f0(source, is_gltf_)};
    return index = static_cast<std::uint32_t>(scene_.surfaces.size() - 1);
  }

  void count_transparent(const aiMaterial& source) {
    float opacity = 1;
    if (source.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity < 1) ++transparent_;
  }

  void add_notes() {
    const auto note = [&](std::size_t count, const std::string& text) {
      if (count > 0) scene_.notes.push_back(fmt::format("{}: {}", file_, text));
    };
    note(without_area_, counted(without_area_, "triangle") + " without area left out");
    note(without_uv_, "a texture without texture coordinates on " +
                          counted(without_uv_, "mesh part") + ": the factor colour is used");
    note(transparent_, counted(transparent_, "transparent material") + " drawn opaque");
  }

  std::string file_;
  bool is_gltf_;
  const aiScene& source_;
  Scene& scene_;
  TextureImport textures_;
  std::vector<Surfaces> surfaces_of_material_;
  std::size_t without_area_ = 0, without_uv_ = 0, transparent_ = 0;
};

void read_meshes(const std::filesystem::path& file, bool is_gltf, Scene& scene) {
  Assimp::Importer importer;
  const aiScene* source = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!source)
    throw InputError(InputFault::malformed_file,
                     fmt::format("{}: {}", file.string(), one_line(importer.GetErrorString())));
  if (!source->mRootNode || (source->mFlags & AI_SCENE_FLAGS_INCOMPLETE))
    throw InputError(InputFault::missing, fmt::format("{}: no triangles", file.string()));
  Collector(file, is_gltf, *source, scene).collect();
}

void add(const GltfLight& light, LightSet& lights) {
  switch (light.kind) {
  case LightKind::spot:
    return lights.add_spot(light.position, light.direction, light.intensity, light.inner_angle,
                           light.outer_angle);
  case LightKind::directional:
    return lights.add_directional(light.direction, light.intensity);
  default:
    return lights.add_omni(light.position, light.intensity);
  }
}

/// Adds the lights; returns whether there is a camera.
bool apply(const GltfNodes& nodes, const std::string& file, Scene& scene) {
  for (const GltfLight& light : nodes.lights) {
    try {
      add(light, scene.lights);
    } catch (const InputError& error) {
      throw InputError(error.fault(), fmt::format("{}: {}", file, error.what()));
    }
  }
  if (nodes.orthographic > 0)
    scene.notes.push_back(fmt::format("{}: {} left out: only perspective is supported", file,
                                      counted(nodes.orthographic, "orthographic camera")));
  if (nodes.camera) scene.camera = *nodes.camera;
  return nodes.camera.has_value();
}

} // namespace

bool append_model(const std::filesystem::path& file, Scene& scene) {
  const std::string extension = lower_extension(file);
  if (extension == ".obj") {
    for (const std::string& library : check_obj(file))
      scene.notes.push_back(fmt::format(
          "{}: material library '{}' not found: its materials are grey", file.string(), library));
    read_meshes(file, false, scene);
    return false;
  }
  if (std::ranges::find(model_extensions, extension) == model_extensions.end())
    throw InputError(InputFault::unsupported,
                     fmt::format("{}: unknown kind of model '{}'; known: {}", file.string(),
                                 extension, fmt::join(model_extensions, ", ")));
  const GltfNodes nodes = read_gltf_nodes(file);
  read_meshes(file, true, scene);
  return apply(nodes, file.string(), scene);
}

Scene import_model(const std::filesystem::path& file) {
  Scene scene;
  scene.name = file.stem().string();
  if (!append_model(file, scene)) {
    scene.camera = framing(scene.mesh);
    scene.notes.push_back(fmt::format("{}: no camera in the file: framed", file.string()));
  }
  return scene;
}

} // namespace lightcuts
