// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A camera that shows the whole mesh: from the front and above at three quarters, or, where that
/// sees clearly deeper into the mesh (a room open to one side), straight along an axis.
/// The mesh must have triangles.
[[nodiscard]] Camera framing(const TriangleMesh& mesh);

} // namespace lightcuts
