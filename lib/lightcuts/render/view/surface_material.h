// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/scene/scene.h>
#include <lightcuts/render/view/occluder.h>

namespace lightcuts {

/// The surface's material where its texture has the colour `texel` (finite, >= 0): what the
/// base colour multiplies (see Surface) times texel, at most the largest float. The material of a
/// valid surface stays valid.
[[nodiscard]] Material textured(const Surface& surface, const glm::vec3& texel);

/// The material at a hit on the scene's mesh, its texture looked up with uv, and times the colour,
/// interpolated between the triangle's vertices. The scene must be valid.
[[nodiscard]] Material material_at(const Scene& scene, const Hit& hit);

/// The radiance that the surface emits at a hit, its texture looked up alike. The scene must be
/// valid.
[[nodiscard]] glm::vec3 emission_at(const Scene& scene, const Hit& hit);

} // namespace lightcuts
