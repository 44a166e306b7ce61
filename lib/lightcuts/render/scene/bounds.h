// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The smallest box around all positions that a triangle uses, metres; positions that no triangle
/// uses do not count. Empty (`Box::empty()`) where there is no triangle.
[[nodiscard]] Box scene_bounds(const TriangleMesh& mesh);

/// Length of the box's diagonal, metres, computed in double so that it cannot overflow; 0 for an
/// empty box.
[[nodiscard]] double diagonal_length(const Box& box);

} // namespace lightcuts
