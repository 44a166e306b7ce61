// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <lightcuts/render/view/scene_view.h>
#include <oracle/campaign/check.h>
#include <oracle/campaign/hunt.h>

namespace lightcuts::oracle {

/// The view that check() has at a place that is_beside_light() of the subject's tree.
[[nodiscard]] gen::View view_beside_light_at(const SceneView& view, const Topology& topology,
                                             const CheckConfig& config, std::uint64_t place);

/// The shading point that check() visits at the place and up to three that pixels beside it see,
/// 1 to 8 pixels apart in either direction, as far as they can be bounded together: views without
/// lights.
[[nodiscard]] Case block_at(const SceneView& view, const CheckConfig& config, std::uint64_t place);

/// The shading point that check() visits at the place, with all lights of the scene; those that are
/// not seen from there are hidden. Its neighbours in a block, if it is_of_block(), see all. Beside
/// a light, the subject builds its tree for it, and all are seen.
[[nodiscard]] Case case_of(const Subject& subject, const SceneView& view, const CheckConfig& config,
                           std::uint64_t place);

/// The shading point that check() visits at the place, with twelve lights of the scene at most,
/// drawn at random: what check() looks at where all lights would take too long.
[[nodiscard]] Case excerpt_of(const SceneView& view, const CheckConfig& config,
                              std::uint64_t place);

/// The first property that check() found violated, violations before waste, of those that
/// check_case() finds violated in lights and a point alone: not so where it takes the scene's
/// triangles (occlusion-equals-brute-force, proven-visibility-holds), and of materials. Not shrunk.
[[nodiscard]] std::optional<Counterexample> counterexample_of(const Subject& subject,
                                                              const SceneView& view,
                                                              const CheckConfig& config,
                                                              const CheckResult& result);

} // namespace lightcuts::oracle
