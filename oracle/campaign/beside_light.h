// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/lights/light_set.h>
#include <oracle/cases/stress_scene.h>
#include <oracle/subjects/topology.h>

namespace lightcuts::oracle {

/// A view from just outside a cluster of the tree, beside the light that touches that side of its
/// box and facing it: there, a bound is no larger than it has to be, however many lights it is of.
/// The cluster, its side and the distance, from a millionth of its size up to all of it, are drawn
/// by `random`. Where that light is directional, which is nowhere: `otherwise`, whose material the
/// view has in any case.
[[nodiscard]] gen::View view_beside_light(const LightSet& lights, const Topology& topology,
                                          std::uint64_t random, const gen::View& otherwise);

} // namespace lightcuts::oracle
