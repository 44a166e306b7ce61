// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <oracle/cases/case.h>
#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// Calls f(index, PointCase) for each view of the case until it returns true; returns whether it
/// did.
template <class F>
bool for_each_view(const Case& on, const Topology& topology, const LightSet& lights,
                   std::uint64_t place, F&& f) {
  Truth truth;
  std::vector<char> visible;
  for (std::size_t i = 0; i < on.views.size(); ++i) {
    const ShadingPoint point = on.views[i].view.point();
    visible.assign(lights.size(), 1);
    for (const std::uint32_t hidden : on.views[i].hidden) visible[hidden] = 0;
    truth.evaluate(topology, lights, point, visible);
    if (f(i, PointCase{place, point, visible, truth})) return true;
  }
  return false;
}

} // namespace lightcuts::oracle
