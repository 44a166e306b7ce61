// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/subjects/topology.h>

namespace lightcuts::oracle {

/// Wide enough that sums and products of a few floats are exact whatever their exponents.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<700, boost::multiprecision::digit_base_2>>;

/// RGB in long double: what is exact to within truth_error.
using Wide = std::array<long double, 3>;

/// Relative error of contribution(), of every sum of contributions, and of nothing else. Mostly
/// that of lobes at their sharpest, in roundings of 2^-64 = epsilon/2:
///   Phong's power, 2^20 times the cosine's 26 of them, or the logarithm of what is left, 2^13.5,
///     over a cosine above 2^-10 and its logarithm: 2^25.3;
///   Ward's e^-(T/alpha)^2, 2 T/alpha 1/alpha times the tangent's 50 of them, with 1/alpha at most
///     2^14 and T/alpha 2^6.7: 2^27.4.
inline constexpr long double truth_error = 0x1p27L * std::numeric_limits<long double>::epsilon();

/// Unoccluded radiance that the light sends to the viewer of `point`, written anew from the
/// definitions (Light, LightKind, Material and its lobes) in long double, with a dot product that
/// does not cancel. min_distance as LightSet has it.
[[nodiscard]] Wide contribution(const Light& light, const ShadingPoint& point, float min_distance);

/// contribution() in 700-bit arithmetic, one channel: what decides where long double cannot.
[[nodiscard]] Exact exact_contribution(const Light& light, const ShadingPoint& point,
                                       float min_distance, int channel);

/// The true contributions of all clusters of a tree at one shading point, in one bottom-up pass.
/// Keeps its memory from one point to the next.
class Truth {
public:
  /// visible: per light, whether it is seen from the point. References must outlive the next call.
  void evaluate(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                std::span<const char> visible);

  /// Sum over the cluster's lights, as if nothing occluded any of them.
  [[nodiscard]] const Wide& open(std::uint32_t node) const { return open_[node]; }
  /// contribution() of one light of the tree.
  [[nodiscard]] const Wide& of_light(std::uint32_t light) const { return of_lights_[light]; }
  /// Sum over the cluster's visible lights.
  [[nodiscard]] const Wide& seen(std::uint32_t node) const { return seen_[node]; }

  [[nodiscard]] const Topology& topology() const { return *topology_; }
  [[nodiscard]] const LightSet& lights() const { return *lights_; }

  [[nodiscard]] Exact exact_open(std::uint32_t node, int channel) const {
    return exact(node, channel, false);
  }
  [[nodiscard]] Exact exact_seen(std::uint32_t node, int channel) const {
    return exact(node, channel, true);
  }

private:
  [[nodiscard]] Exact exact(std::uint32_t node, int channel, bool only_visible) const;

  const Topology* topology_ = nullptr;
  const LightSet* lights_ = nullptr;
  const ShadingPoint* point_ = nullptr;
  std::span<const char> visible_;
  std::vector<Wide> of_lights_, open_, seen_;
};

/// Whether bound >= value in real numbers, value being known to within margin: decided in long
/// double if that can, else by exact(), which gives the value as Exact. NaN is never enough; +inf
/// always is.
template <class MakeExact>
[[nodiscard]] bool dominates(float bound, long double value, long double margin,
                             MakeExact&& exact) {
  if (!(bound >= 0)) return false;
  if (bound == std::numeric_limits<float>::infinity()) return true;
  if (bound >= value + margin) return true;
  if (bound < value - margin) return false;
  return Exact(bound) >= exact();
}

} // namespace lightcuts::oracle
