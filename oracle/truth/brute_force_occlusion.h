// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/scene/scene.h>
#include <lightcuts/render/view/occluder.h>

namespace lightcuts {

/// What can be said for certain of a segment and a mesh.
enum class Occlusion { clear, blocked, undecided };

/// Tests the ray against every triangle in double precision. `blocked`: it meets a triangle by a
/// margin larger than any error that a single-precision Pluecker test (Embree's robust mode) may
/// commit; `clear`: it misses every triangle by such a margin; `undecided` otherwise. The margins
/// are forward error bounds, derived in the source and relative to the terms of each formula: they
/// hold at any scale. Time is proportional to the mesh. ray finite, indices in range.
[[nodiscard]] Occlusion brute_force_occlusion(const TriangleMesh& mesh, const ShadowRay& ray);

} // namespace lightcuts
