// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// A comparison for one cluster: a left side, 700 bits wide, with what may be no less.
struct BothSides {
  std::string left_name, right_name;
  std::array<Exact, 3> left;
  std::array<double, 3> right;
  std::string rows = {};       ///< what else comes into it, see text_rows.h
  bool must_be_finite = false; ///< all that is claimed is that the right side is finite
};

/// The truth, and the subject's bound.
[[nodiscard]] inline BothSides bound_sides(const PointAnswers& of, std::uint32_t node) {
  BothSides sides{"truth", "the subject's bound", {}, {}};
  for (int c = 0; c < 3; ++c) {
    sides.left[std::size_t(c)] = of.at.truth.exact_open(node, c);
    sides.right[std::size_t(c)] = of.bounds()[node][c];
  }
  return sides;
}

/// 0 for what is none.
[[nodiscard]] inline Exact exact_of(double value) {
  return std::isfinite(value) ? Exact(value) : Exact(0);
}

} // namespace lightcuts::oracle
