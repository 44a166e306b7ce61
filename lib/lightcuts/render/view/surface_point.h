// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>
#include <lightcuts/render/view/occluder.h>

namespace lightcuts {

/// What shading and shadow rays need to know of the point that a camera ray hit.
struct SurfacePoint {
  glm::vec3 position;         ///< metres
  glm::vec3 geometric_normal; ///< unit, of the face, towards the viewer
  glm::vec3 shading_normal;   ///< unit, interpolated between vertices, towards the viewer
  glm::vec3 ray_origin;       ///< where shadow rays start: off the surface, on the viewer's side
};

/// The point of `mesh` at `hit`, seen along `view_direction` (from the viewer to the surface, any
/// length but zero). The shading normal is the geometric one where a vertex has none, where the
/// vertices' cancel out, or where the interpolated one would face away from the viewer. A ray
/// from ray_origin to a light in front of the hit triangle does not meet that triangle, if the
/// triangle's height is at least 2^-10 of its longest side. Never NaN.
[[nodiscard]] SurfacePoint surface_point(const TriangleMesh& mesh, const Hit& hit,
                                         const glm::vec3& view_direction);

} // namespace lightcuts
