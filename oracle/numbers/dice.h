// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts::gen {

/// Random numbers of the kinds that this field finds hard. The same seed gives the same bits.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// Rolls what the bytes say, so that a fuzzer chooses, as few of them for each number as will do;
  /// after the last, the numbers of seed 0. The bytes must outlive these dice and all aside.
  explicit Dice(std::span<const std::uint8_t> bytes) : state_(0), bytes_(bytes) {}

  /// Other dice, whose numbers these will not roll; these stay as they are. They roll the same
  /// bytes, if any, but not in step.
  [[nodiscard]] Dice aside() const {
    Dice other(~splitmix64(state_));
    if (!bytes_.empty()) other.bytes_ = bytes_.subspan(1);
    return other;
  }

  std::uint64_t bits() { return bytes_.empty() ? splitmix64(state_++) : taken(8); }
  int below(int n) {
    const std::uint64_t roll = bytes_.empty() ? bits() : taken(n <= 256 ? 1 : 4);
    return static_cast<int>(roll % static_cast<std::uint64_t>(n));
  }
  bool one_in(int n) { return below(n) == 0; }
  int between(int first, int last) { return first + below(last - first + 1); }
  double uniform(double lo, double hi) { return lo + (hi - lo) * double(bits() >> 11) * 0x1p-53; }
  float sign() { return one_in(2) ? 1.0F : -1.0F; }
  /// Of either sign, its magnitude spread evenly over the scales from 10^lo to 10^hi.
  float log_uniform(double lo, double hi) {
    const float s = sign(); // apart: the order of operands is the compiler's choice
    return s * finite(std::pow(10.0, uniform(lo, hi)));
  }
  template <class T>
  T pick(std::initializer_list<T> values) {
    return values.begin()[below(static_cast<int>(values.size()))];
  }
  static float finite(double v) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(v, -largest, largest));
  }

  float subnormal() { return float(between(-100, 100)) * 0x1p-149F; }
  float finite_float() {
    switch (below(8)) {
    case 0:
      return pick({0.0F, -0.0F});
    case 1:
      return float(between(-4, 4));
    case 2:
      return float(between(-8, 8)) / 4;
    case 3:
      return float(uniform(-1, 1));
    case 4:
      return log_uniform(-30, 30);
    case 5:
      return log_uniform(-45, 38.6);
    case 6:
      return subnormal();
    default:
      return pick({0x1.fffffep127F, -0x1.fffffep127F, 0x1p-126F, 1e8F, -1e8F, 0x1p-149F});
    }
  }
  glm::vec3 finite_vector() { return {finite_float(), finite_float(), finite_float()}; }
  glm::vec3 lattice(int radius = 2) {
    return {between(-radius, radius), between(-radius, radius), between(-radius, radius)};
  }
  glm::vec3 in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

  glm::vec3 axis() {
    glm::vec3 v(0);
    v[below(3)] = sign();
    return v;
  }
  glm::vec3 unit_vector() {
    switch (below(5)) {
    case 0:
      return axis();
    case 1:
      return normalised(glm::dvec3(lattice()));
    case 2: { // grazing: an axis but for very small components
      glm::vec3 v = axis();
      for (int i = 0; i < 3; ++i)
        if (v[i] == 0) v[i] = one_in(2) ? subnormal() : log_uniform(-45, -7);
      return v;
    }
    default:
      return normalised(glm::dvec3(in_cube()));
    }
  }

  /// From a point towards another, past it at a right angle, or anywhere.
  glm::vec3 direction(const glm::vec3& from, const glm::vec3& to) {
    const glm::dvec3 d = glm::dvec3(to) - glm::dvec3(from);
    const double length = glm::length(d);
    if (!(length > 1e-30) || one_in(2)) return unit_vector();
    const glm::dvec3 unit = d / length;
    if (one_in(2)) return glm::vec3(unit);
    const glm::dvec3 side = glm::cross(unit, glm::dvec3(unit_vector()));
    return glm::length(side) > 1e-6 ? glm::vec3(glm::normalize(side)) : glm::vec3(unit);
  }

  static glm::vec3 not_negative(const glm::vec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  }
  /// Per channel, mostly at most 1.
  glm::vec3 reflectance() {
    if (one_in(10)) return not_negative(finite_vector());
    return one_in(3) ? glm::vec3(0.5F) : not_negative(in_cube());
  }

private:
  /// The next bytes as a number, the first the lowest; fewer at the end.
  std::uint64_t taken(std::size_t count) {
    std::uint64_t number = 0;
    count = std::min(count, bytes_.size());
    for (std::size_t i = 0; i < count; ++i) number |= std::uint64_t{bytes_[i]} << (8 * i);
    bytes_ = bytes_.subspan(count);
    return number;
  }
  static glm::vec3 normalised(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length == 0 ? glm::vec3(0, 0, 1) : glm::vec3(v / length);
  }
  std::uint64_t state_;
  std::span<const std::uint8_t> bytes_;
};

} // namespace lightcuts::gen
