// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <lightcuts/core/lights/light_set.h>
#include <oracle/properties/properties.h>
#include <oracle/subjects/topology.h>

namespace lightcuts::oracle {

/// A tree that a subject claims to have.
struct TreeCase {
  const LightSet& lights;
  const std::string& defect; ///< see TopologyReading
  const Topology* topology;  ///< nothing where it is no tree at all: only of that is asked, then
};

} // namespace lightcuts::oracle
