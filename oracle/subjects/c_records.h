// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/oracle/subject_abi.h>

namespace lightcuts::oracle {

/// Records as the C interface has them, which is written by hand: it must not change when they do.
[[nodiscard]] lightcuts_light as_c(const Light& light);
[[nodiscard]] lightcuts_point as_c(const ShadingPoint& point);
[[nodiscard]] lightcuts_cut_config as_c(const CutConfig& config);

} // namespace lightcuts::oracle
