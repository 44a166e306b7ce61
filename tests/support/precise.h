// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>
#include <oracle/truth/truth.h>

/// Real numbers, or so nearly that no float and no double can tell the difference.
namespace lightcuts::precise {

namespace mp = boost::multiprecision;

/// Dot products of floats need bits 2^-298 .. 2^259 and are exact in these 700; any exponent.
using Exact = oracle::Exact;
/// 128 bits, any exponent: relative error 2^-127 per operation.
using Quad = mp::number<mp::cpp_bin_float<128, mp::digit_base_2>, mp::et_off>;
/// One number per colour channel.
using Colour = std::array<Quad, 3>;

inline Exact square(const Exact& v) { return v * v; }

inline bool same_sign(double value, const Exact& exact) {
  return (value > 0) == (exact > 0) && (value < 0) == (exact < 0);
}

/// n.(y - x), exactly.
[[nodiscard]] Exact dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y);
/// |y - x|^2, exactly.
[[nodiscard]] Exact distance2(const glm::vec3& x, const glm::vec3& y);

[[nodiscard]] Quad length(const glm::vec3& v);

/// base^exponent; 2^20 multiplications lose less than 20 of the 128 bits.
[[nodiscard]] Quad power(Quad base, float exponent);

[[nodiscard]] Quad pi();

/// Radiance that the light sends to the viewer, in real numbers.
[[nodiscard]] Colour contribution(const ShadingPoint& point, const Light& light,
                                  float min_distance = 0);
/// Radiance that an omni light of intensity 1 at y sends to the viewer.
[[nodiscard]] Colour transfer(const ShadingPoint& point, const glm::vec3& y);

/// The sum over all lights that `visible` says are seen.
[[nodiscard]] Colour sum(const LightSet& lights, const ShadingPoint& point,
                         const std::function<bool(std::uint32_t)>& visible);

/// What every node of the tree contributes with all its lights visible.
[[nodiscard]] std::vector<Colour> contributions(const LightTree& tree, const ShadingPoint& point);

} // namespace lightcuts::precise
