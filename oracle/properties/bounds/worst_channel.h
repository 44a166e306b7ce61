// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// The channel with the largest value / bound, and whether all hold.
struct WorstChannel {
  bool holds = true;
  int channel = 0;
  double ratio = 0;
  long double value = 0;

  void add(int c, bool channel_holds, long double left, double bound) {
    const double r = bound == std::numeric_limits<float>::infinity() ? 0 : ratio_of(left, bound);
    const bool first_failure = holds && !channel_holds;
    if (first_failure || (r > ratio && (holds || !channel_holds))) {
      channel = c;
      value = left;
    }
    ratio = std::max(ratio, r);
    holds = holds && channel_holds;
  }
};

/// Both sides of a comparison for a node, in one channel, with nine digits, or as many as tell them
/// apart.
[[nodiscard]] std::string sides_text(const ShadingPoint& point, const Topology& topology,
                                     std::uint32_t node, int channel, const char* left,
                                     long double value, const char* right, long double limit);

inline std::string sides_text(const PointAnswers& of, std::uint32_t node, const WorstChannel& worst,
                              const char* left, const char* right, long double limit) {
  return sides_text(of.at.point, of.topology(), node, worst.channel, left, worst.value, right,
                    limit);
}

} // namespace lightcuts::oracle
