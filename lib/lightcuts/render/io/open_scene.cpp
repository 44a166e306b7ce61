// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/open_scene.h>

#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/io/models/model_import.h>
#include <lightcuts/render/io/scene_files.h>
#include <lightcuts/render/io/scene_json.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/scene/camera_fault.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

void validate(const TriangleMesh& mesh, std::size_t surfaces) {
  if (mesh.triangles.empty()) throw InputError(InputFault::missing, "no triangles");
  if (mesh.normals.size() != mesh.positions.size())
    throw InputError(
        InputFault::inconsistent,
        fmt::format("{} normals for {} positions", mesh.normals.size(), mesh.positions.size()));
  if (mesh.surface.size() != mesh.triangles.size())
    throw InputError(InputFault::inconsistent,
                     fmt::format("{} surface indices for {} triangles", mesh.surface.size(),
                                 mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!is_finite(mesh.positions[i]))
      throw InputError(InputFault::not_finite, fmt::format("position {} is not finite", i));
    const double length = glm::length(glm::dvec3(mesh.normals[i]));
    // Ten times the rounding of three floats; NaN fails too.
    if (!(length == 0 || std::abs(length - 1) <= 1e-6))
      throw InputError(std::isfinite(length) ? InputFault::not_unit : InputFault::not_finite,
                       fmt::format("normal {} has length {}, expected 0 or 1", i, length));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner)
      if (mesh.triangles[i][corner] >= mesh.positions.size())
        throw InputError(InputFault::inconsistent,
                         fmt::format("triangle {} uses position {} of {}", i,
                                     mesh.triangles[i][corner], mesh.positions.size()));
    if (mesh.surface[i] >= surfaces)
      throw InputError(InputFault::inconsistent, fmt::format("triangle {} uses surface {} of {}", i,
                                                             mesh.surface[i], surfaces));
  }
}

void validate_uv(const TriangleMesh& mesh) {
  for (const auto* uv : {&mesh.uv, &mesh.emission_uv}) {
    if (!uv->empty() && uv->size() != mesh.positions.size())
      throw InputError(InputFault::inconsistent,
                       fmt::format("{} texture coordinates for {} positions", uv->size(),
                                   mesh.positions.size()));
    for (std::size_t i = 0; i < uv->size(); ++i)
      if (!std::isfinite((*uv)[i].x) || !std::isfinite((*uv)[i].y))
        throw InputError(InputFault::not_finite,
                         fmt::format("texture coordinate {} is not finite", i));
  }
}

void validate_colours(const TriangleMesh& mesh) {
  if (!mesh.colours.empty() && mesh.colours.size() != mesh.positions.size())
    throw InputError(
        InputFault::inconsistent,
        fmt::format("{} colours for {} positions", mesh.colours.size(), mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.colours.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!(mesh.colours[i][c] >= 0 && std::isfinite(mesh.colours[i][c])))
        throw InputError(
            fault_of(mesh.colours[i][c]),
            fmt::format("colour {}.{} is {}, out of its domain", i, "rgb"[c], mesh.colours[i][c]));
}

void validate_texture(const Surface& surface, const Scene& scene) {
  const auto refuse = [&](InputFault fault, const std::string& why) {
    throw InputError(fault, fmt::format("surface '{}': {}", surface.name, why));
  };
  const auto check = [&](const std::optional<SurfaceTexture>& texture, bool has_uv) {
    if (!texture) return;
    if (texture->index >= scene.textures.size())
      refuse(InputFault::inconsistent,
             fmt::format("texture {} of {}", texture->index, scene.textures.size()));
    if (!has_uv) refuse(InputFault::missing, "a texture, but the mesh has no texture coordinates");
  };
  check(surface.texture, !scene.mesh.uv.empty());
  check(surface.emission_texture, !scene.mesh.emission_uv.empty());
  const auto* metal = std::get_if<CookTorrance>(&surface.material.lobe);
  for (int c = 0; c < 3; ++c) {
    const float part = surface.tinted_f0[c], all = metal ? metal->f0[c] : 0;
    if (!(part >= 0 && part <= all))
      refuse(fault_of(part),
             fmt::format("tinted_f0.{} is {}, expected 0 to {}", "rgb"[c], part, all));
  }
}

void validate(const Surface& surface) {
  try {
    validate(surface.material);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("surface '{}': {}", surface.name, error.what()));
  }
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(surface.emission[c]) || surface.emission[c] < 0)
      throw InputError(fault_of(surface.emission[c]),
                       fmt::format("surface '{}': emission.{} is {}, out of its domain",
                                   surface.name, "rgb"[c], surface.emission[c]));
}

void check(const Scene& scene) {
  validate(scene.mesh, scene.surfaces.size());
  validate_uv(scene.mesh);
  validate_colours(scene.mesh);
  for (const Surface& surface : scene.surfaces) {
    validate(surface);
    validate_texture(surface, scene);
  }
  if (const auto fault = camera_fault(scene.camera))
    throw InputError(fault->cause, "camera: " + fault->what);
  for (int side = 0; side < 2; ++side)
    if (scene.image_size[side] < 1 || scene.image_size[side] > max_image_side)
      throw InputError(InputFault::out_of_domain,
                       fmt::format("image {} is {}, expected 1 to {}", side ? "height" : "width",
                                   scene.image_size[side], max_image_side));
}

Scene read(const std::string& spec, bool allow_outside) {
  if (is_builtin(spec)) return make_builtin(spec);
  const std::filesystem::path file(spec);
  const std::string extension = lower_extension(file);
  if (extension == scene_json_extension)
    return load_scene_json(file, FileAccess(file, allow_outside));
  if (is_scene_file(file)) return import_model(file, FileAccess(file, allow_outside));
  if (spec.find_first_of("./") == std::string::npos)
    return make_builtin(spec); // says what is known
  throw InputError(InputFault::unsupported,
                   fmt::format("{}: unknown kind of scene '{}'; known: a built-in name, {}", spec,
                               file.extension().string(), fmt::join(scene_extensions, ", ")));
}

} // namespace

void validate(const Scene& scene) {
  try {
    check(scene);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("{}: {}", scene.name, error.what()));
  }
}

Scene open_scene(const std::string& spec, bool allow_outside) {
  // Names of files, and names in them, may be of several lines.
  try {
    Scene scene = read(spec, allow_outside);
    validate(scene);
    for (std::string& note : scene.notes) note = one_line(std::move(note));
    return scene;
  } catch (const InputError& error) {
    throw InputError(error.fault(), one_line(error.what()));
  }
}

} // namespace lightcuts
