// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A distance for LightSet::set_min_distance, metres, where `count` >= 1 oriented lights stand for
/// the light that the mesh reflects: sqrt(A / (pi count)), A being the area of all triangles, that
/// is, the radius of the disc that each light stands for. Nothing sets it by itself.
///
/// A patch of area a = A / count and radiance L causes an irradiance of at most pi L, however
/// close. The light in its place has the intensity L a and would cause more where d^2 < a / pi: a
/// bright spot. Clamped, it never does, and farther away nothing changes. Some light between close
/// surfaces (corners) is lost by it. 0 for a mesh without area.
[[nodiscard]] float suggested_min_distance(const TriangleMesh& mesh, std::size_t count);

} // namespace lightcuts
