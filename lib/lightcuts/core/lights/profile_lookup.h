// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include <lightcuts/core/lights/profile.h>

namespace lightcuts::detail {

/// Between two half-planes, or two rows, of a table: what is there is the mean by these weights.
struct Between {
  std::size_t first = 0, next = 0;
  double weight = 1, next_weight = 0; ///< not negative, their sum is positive

  [[nodiscard]] double mean(double at_first, double at_next) const {
    return (weight * at_first + next_weight * at_next) / (weight + next_weight);
  }
};

/// The share in a direction between half-planes and rows; rounding 2^-50 of it.
[[nodiscard]] inline double share_between(const ProfileTable& table, const Between& plane,
                                          const Between& row) {
  const auto in_row = [&](std::size_t i) {
    return plane.mean(table.share(plane.first, i), table.share(plane.next, i));
  };
  return row.mean(in_row(row.first), in_row(row.next));
}

/// The row whose cosine is the last one of at least c, or the first; never the last of all.
[[nodiscard]] inline std::size_t row_at(const ProfileTable& table, double c) {
  const auto& cosines = table.cosines;
  const auto below = std::partition_point(cosines.begin(), cosines.end(),
                                          [c](float cosine) { return double(cosine) >= c; });
  const auto row = std::max<std::ptrdiff_t>(below - cosines.begin() - 1, 0);
  return std::min(std::size_t(row), table.rows() - 2);
}

/// Where c, from -1 to 1, lies.
[[nodiscard]] inline Between rows_at(const ProfileTable& table, double c) {
  const std::size_t row = row_at(table, c);
  return {row, row + 1, c - table.cosines[row + 1], table.cosines[row] - c};
}

/// The largest share between half-planes for cosines from `least` to `most`, of which beyond -1 and
/// 1 there are none: at the ends, or in a row between them.
[[nodiscard]] inline double max_share(const ProfileTable& table, const Between& plane, double least,
                                      double most) {
  const double from = std::clamp(most, -1.0, 1.0), to = std::clamp(least, -1.0, 1.0);
  double share = std::max(share_between(table, plane, rows_at(table, from)),
                          share_between(table, plane, rows_at(table, to)));
  for (std::size_t row = row_at(table, from); row < table.rows() && table.cosines[row] >= to; ++row)
    if (table.cosines[row] <= from)
      share =
          std::max(share, plane.mean(table.share(plane.first, row), table.share(plane.next, row)));
  return share;
}

} // namespace lightcuts::detail
