// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {

struct CutConfig {
  float threshold = 0.01F;       ///< error bound per cluster, relative to the total; default 0.01
  std::uint32_t max_size = 1000; ///< largest number of clusters in a cut, >= 1; default 1000
  float black_level = 0;         ///< a bound up to this radiance is always good enough; default 0
  /// Nothing comes between the point and any light: `visible` is not called, and the certified
  /// error, which has lower bounds then, is smaller; default false
  bool unoccluded = false;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("threshold", &CutConfig::threshold, domain::not_negative);
    field("max_size", &CutConfig::max_size, domain::within(1, 0xffffffff));
    field("black_level", &CutConfig::black_level, domain::not_negative);
    field("unoccluded", &CutConfig::unoccluded);
  }
  bool operator==(const CutConfig&) const = default;
};

/// Throws InputError, naming the field: threshold and black_level are >= 0, max_size >= 1.
inline void validate(const CutConfig& config) {
  if (!(config.threshold >= 0))
    throw InputError(fault_of(config.threshold),
                     "threshold: must be a number that is not negative");
  if (!(config.black_level >= 0))
    throw InputError(fault_of(config.black_level),
                     "black_level: must be a number that is not negative");
  if (config.max_size == 0)
    throw InputError(InputFault::out_of_domain, "max_size: a cut has at least 1 cluster");
}

/// Why refinement ended.
enum class CutEnd {
  converged,   ///< every bound obeys the threshold
  black_level, ///< every bound obeys the threshold or is at most black_level, and one needed that
  max_size     ///< the largest size was reached first
};

/// What a CutSelector found; valid until its next call.
struct Cut {
  glm::vec3 radiance{0};                ///< sum of the estimates; +inf above the largest float
  glm::vec3 certified_error{0};         ///< >= |radiance - exact|, rounding included
  std::span<const CutCluster> clusters; ///< a partition of the lights
  std::uint32_t shadow_rays = 0;        ///< calls of `visible`
  CutEnd end = CutEnd::converged;
};

} // namespace lightcuts
