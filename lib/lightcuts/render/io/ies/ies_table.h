// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <lightcuts/core/lights/profile.h>

namespace lightcuts {

/// Candela of type C photometry: one list for each horizontal angle.
struct Candela {
  std::vector<double> vertical;   ///< degrees, increasing, 0 to 180
  std::vector<double> horizontal; ///< degrees, increasing
  std::vector<std::vector<double>> columns;

  [[nodiscard]] double peak() const;
};

/// The horizontal angles that files have for a luminaire of some symmetry.
enum class Symmetry {
  round,        ///< 0 alone
  quadrant,     ///< 0 to 90
  bilateral,    ///< 0 to 180: both sides of the plane through 0 and 180 are alike
  across,       ///< 90 to 270: both sides of the plane through 90 and 270 are
  none,         ///< 0 to 360
  none_unclosed ///< 0 to less than 360: the first follows the last
};

/// All around, with half-planes and rows in between; see read_ies().
[[nodiscard]] ProfileTable table_of(const Candela& candela, Symmetry symmetry);

} // namespace lightcuts
