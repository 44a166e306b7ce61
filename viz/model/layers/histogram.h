// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lightcuts::viz {

/// Where the bins of a histogram lie; bin i has the values from edge(i), included, to edge(i + 1),
/// which only the last bin includes.
struct HistogramRange {
  double lo = 0, hi = 1;    ///< finite, lo <= hi; where they are equal, all is in bin 0
  std::uint32_t bins = 64;  ///< at least 1
  bool logarithmic = false; ///< equal ratios, not equal differences; needs lo > 0

  /// The border below bin i, of bins + 1.
  [[nodiscard]] double edge(std::uint32_t i) const;
};

struct Histogram {
  HistogramRange range;
  std::vector<std::uint64_t> counts; ///< of the bins
  std::uint64_t nan = 0, positive_infinite = 0, negative_infinite = 0;
  std::uint64_t below = 0, above = 0; ///< finite, but not in the range
};

/// Counts each value once.
[[nodiscard]] Histogram histogram_of(std::span<const float> values, const HistogramRange& range);

/// From the smallest to the largest finite value (> 0 if logarithmic); 0 to 1, or 1 to 10, where
/// there is none.
[[nodiscard]] HistogramRange range_of(std::span<const float> values, std::uint32_t bins,
                                      bool logarithmic);

/// For whole numbers from lo to hi: bins of equally many each, at most `most` bins; three where
/// there is one number only, so that it stands in the middle. lo and hi whole, lo <= hi.
[[nodiscard]] HistogramRange whole_number_range(double lo, double hi, std::uint32_t most);

/// For each of `percents`, in [0, 100], the smallest value such that at least so many percent of
/// the values are not above it. NaN does not count; NaN where there is nothing else.
[[nodiscard]] std::vector<float> percentiles(std::span<const float> values,
                                             std::span<const double> percents);

/// At most `most` round numbers from lo to hi: steps of 1, 2 or 5 times a power of ten. On a
/// logarithmic axis (lo > 0): 1, 2 and 5, or 1 and 3 times the powers of ten, or some of these
/// powers alone, whatever there is room for; steps where the range is narrower than that. None
/// unless lo <= hi and hi - lo is finite.
[[nodiscard]] std::vector<double> nice_ticks(double lo, double hi, std::uint32_t most,
                                             bool logarithmic);

} // namespace lightcuts::viz
