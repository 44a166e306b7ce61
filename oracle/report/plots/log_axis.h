// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace lightcuts::oracle {

/// A logarithmic axis of a plot that grows to hold what is drawn.
class LogAxis {
public:
  /// Takes a value in; false, and nothing taken, unless it is positive and finite.
  bool include(double value);

  /// gnuplot commands for the axis "x" or "y": range with some room, and ticks at 1, 2, 5 or at
  /// the powers of ten, each labelled with the number and `unit` ("%%" for %). Nothing taken in:
  /// 0.1 to 1.
  [[nodiscard]] std::string commands(const std::string& axis, const std::string& unit) const;

private:
  double low_ = 0, high_ = 0; // 0: nothing taken in
};

} // namespace lightcuts::oracle
