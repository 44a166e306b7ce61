// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A camera for a mesh without one. An object is seen whole, from the front (+z), its right and
/// above at three quarters. What is seen from its middle decides that it is none: walls that show
/// their fronts, near the mesh's box. Where they are all around, the camera stands within; where
/// they are open to one side, it looks straight in from there; where they hide what is before them
/// from the front, the three quarters are from another side. The mesh must have triangles.
[[nodiscard]] Camera framing(const TriangleMesh& mesh);

} // namespace lightcuts
