// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/difference_box.h>
#include <lightcuts/core/lights/profile_lookup.h>

namespace lightcuts::detail {

/// (P, Q) of ProfileTable for a way of any length, and a magnitude that either may have cancelled
/// from.
struct HorizontalWay {
  double p = 0, q = 0;
  double p_scale = 0, q_scale = 0;

  HorizontalWay(const glm::vec3& axis, const glm::vec3& plane, const glm::dvec3& way);
};

/// Between which half-planes of a table light leaves a luminaire at y towards x: E_i of
/// ProfileTable, relative error 2^-35, zero and sign exact.
class HorizontalAngle {
public:
  /// The references have to outlive this.
  HorizontalAngle(const ProfileTable& table, const glm::vec3& axis, const glm::vec3& plane,
                  const glm::vec3& y, const glm::vec3& x)
      : table_(table), axis_(axis), plane_(plane), y_(y), x_(x),
        way_(axis, plane, glm::dvec3(x) - glm::dvec3(y)) {}

  /// The half-planes before and after; of a way along the axis, the first.
  [[nodiscard]] Between sector() const;

private:
  [[nodiscard]] double beyond(std::size_t plane) const;
  [[nodiscard]] double exact_beyond(double cosine, double sine) const;
  /// The sector, but for rounding.
  [[nodiscard]] std::size_t guess() const;

  const ProfileTable& table_;
  const glm::vec3 &axis_, &plane_, &y_, &x_;
  HorizontalWay way_;
};

/// By how much ranges of cosines, and of horizontal angles in radians, are widened to bound what a
/// table has in them: far more than they err by. The end of a range may lie where the table rises
/// from 0; what is found there then differs little from one box to the box around it. Odd, so that
/// no row of a table is likely to be just so far away.
inline constexpr double soft_edge = 0x1.5a7p-24;

/// The horizontal angles of all ways that a box of q has, back along q, widened by soft_edge; all
/// round where they are more than a quarter turn.
class HorizontalRange {
public:
  HorizontalRange(const glm::vec3& axis, const glm::vec3& plane, const DifferenceBox& q);

  /// The largest share of the table within the range and between two cosines; of more than
  /// max_cells cells, and where the range is all round, of the envelope.
  [[nodiscard]] double max_share(const ProfileTable& table, const ProfileTable& envelope,
                                 double least, double most) const;
  static constexpr std::size_t max_cells = 256;

private:
  void add(const glm::dvec2& way);

  bool all_round_ = false, empty_ = true;
  glm::dvec2 begin_{0}, end_{0}; ///< (P, Q), less than pi apart
};

} // namespace lightcuts::detail
