// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct KindTruth<LightKind::omni> : UsualKind {};

} // namespace lightcuts::oracle::radiometry
