// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/material.h>
#include <lightcuts/render/scene/texture.h>

namespace lightcuts {

/// Largest width and height of an image, pixels.
inline constexpr std::uint32_t max_image_side = 16384;

/// A texture on a surface.
struct SurfaceTexture {
  std::uint32_t index = 0; ///< into Scene::textures
  TextureWrap wrap;
};

/// What a triangle is made of.
struct Surface {
  std::string name;
  Material material;
  glm::vec3 emission{0}; ///< radiance seen by the camera, W/(m^2 sr); it lights nothing by itself:
                         ///< see area_lights.h
  std::optional<SurfaceTexture> texture = {}; ///< multiplies the base colour: the diffuse
                                              ///< reflectance and tinted_f0; nothing: 1
  glm::vec3 tinted_f0{0}; ///< the part of CookTorrance::f0, 0 to all of it, that comes of the base
                          ///< colour; 0 for other lobes
  std::optional<SurfaceTexture> emission_texture = {}; ///< multiplies emission; nothing: 1
};

/// All triangles of a scene in world space, metres.
struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;     ///< per position, unit; (0,0,0) means: use the face's normal
  std::vector<glm::vec2> uv;          ///< per position, as Texture::at takes them; or empty
  std::vector<glm::vec2> emission_uv; ///< per position, of Surface::emission_texture; or empty
  std::vector<glm::vec3> colours;    ///< per position, each finite and >= 0, linear; multiplies the
                                     ///< base colour as Surface::texture does; or empty: 1
  std::vector<glm::uvec3> triangles; ///< indices into positions
  std::vector<std::uint32_t> surface; ///< per triangle, index into Scene::surfaces
};

/// Pinhole camera; +y of the image is down.
struct Camera {
  glm::vec3 position{0, 0, 1};
  glm::vec3 target{0, 0, 0};
  glm::vec3 up{0, 1, 0};
  float vertical_fov = 45; ///< degrees, in (0, 180)

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("position", &Camera::position);
    field("target", &Camera::target);
    field("up", &Camera::up);
    field("vertical_fov", &Camera::vertical_fov, domain::within(0, 180));
  }
  bool operator==(const Camera&) const = default;
};

class Backdrop;

/// Lights that have a name together.
struct LightGroup {
  std::string name;
  std::size_t first = 0, count = 0; ///< the lights first to first + count - 1 of Scene::lights

  bool operator==(const LightGroup&) const = default;
};

struct Scene {
  std::string name;
  TriangleMesh mesh;
  std::vector<Surface> surfaces;
  std::vector<Texture> textures;
  LightSet lights;
  std::vector<LightGroup> groups; ///< disjoint, in the order of their lights; others have no name
  /// What the camera sees beyond all surfaces, added; see environment_lights.h.
  std::vector<std::shared_ptr<const Backdrop>> backdrops;
  Camera camera;
  glm::uvec2 image_size{640, 480};
  std::vector<std::string>
      notes; ///< what the reader of the scene left out or made up, one line each
};

} // namespace lightcuts
