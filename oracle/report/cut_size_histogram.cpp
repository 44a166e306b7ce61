// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <oracle/report/plots/gnuplot.h>
#include <oracle/report/plots/plots.h>

namespace lightcuts::oracle {
namespace {

/// Bins of a whole number of sizes each, at most 60, from the smallest size up.
struct Histogram {
  double low = 0, width = 1;
  std::vector<double> shares; // percent
};

Histogram histogram_of(const std::vector<double>& sizes) {
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  Histogram result{std::floor(*least), 1, {}};
  const double span = std::floor(*most) - result.low + 1;
  result.width = std::max(1.0, std::ceil(span / 60));
  result.shares.resize(static_cast<std::size_t>(std::ceil(span / result.width)));
  for (const double size : sizes)
    result.shares[static_cast<std::size_t>((size - result.low) / result.width)] +=
        100.0 / static_cast<double>(sizes.size());
  return result;
}

std::string boxes(const Histogram& histogram) {
  std::string lines;
  for (std::size_t i = 0; i < histogram.shares.size(); ++i)
    lines += fmt::format("{:.17g} {:.17g}\n",
                         histogram.low + (static_cast<double>(i) + 0.5) * histogram.width,
                         histogram.shares[i]);
  return lines;
}

std::string script_of(const std::vector<double>& sizes) {
  const Histogram histogram = histogram_of(sizes);
  const double high =
      histogram.low + histogram.width * static_cast<double>(histogram.shares.size());
  const double mean =
      std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  const bool at_right = mean > (histogram.low + high) / 2;
  return fmt::format(
      "$data << EOD\n{}EOD\n"
      "set xrange [{:.17g}:{:.17g}]\nset boxwidth {:.17g}\nset style fill solid 0.75 noborder\n"
      "set arrow from first {:.17g}, graph 0 to first {:.17g}, graph 1 nohead front "
      "lc rgb '#d55e00' lw 1.6 dt 2\n"
      "set label 'mean {:.1f}' at first {:.17g}, graph 0.96 {} offset {},0 front "
      "textcolor rgb '#b34f00'\n"
      "plot $data using 1:2 with boxes lt 1 notitle",
      boxes(histogram), histogram.low, high, histogram.width, mean, mean, mean, mean,
      at_right ? "right" : "left", at_right ? -0.8 : 0.8);
}

} // namespace

std::string cut_size_histogram(const Report& report) {
  std::vector<double> sizes;
  for (const float size : report.cut_sizes)
    if (std::isfinite(size) && size >= 0) sizes.push_back(size);
  return gnuplot_svg(
      "set xlabel 'cut size (clusters)'\nset ylabel 'pixels'\n"
      "set yrange [0:*]\nset format y '%g %%'\n" +
      (sizes.empty() ? "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle" : script_of(sizes)));
}

} // namespace lightcuts::oracle
