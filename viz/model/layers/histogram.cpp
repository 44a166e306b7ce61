// SPDX-License-Identifier: MIT
#include <viz/model/layers/histogram.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace lightcuts::viz {
namespace {

/// The bin of a value within the range; a first guess set right by the edges.
std::uint32_t bin_of(double value, const HistogramRange& r) {
  const double share = r.logarithmic ? std::log(value / r.lo) / std::log(r.hi / r.lo)
                                     : (value - r.lo) / (r.hi - r.lo);
  if (!(share > 0)) return 0; // lo = hi, too
  auto bin = std::uint32_t(std::min(share * r.bins, double(r.bins - 1)));
  while (bin > 0 && value < r.edge(bin)) --bin;
  while (bin + 1 < r.bins && value >= r.edge(bin + 1)) ++bin;
  return bin;
}

/// digit * 10^exponent, rounded once where that can be.
double decimal(double digit, int exponent) {
  return exponent < 0 ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent);
}

/// The multiples of digit * 10^exponent; nothing where there are more than `most`.
std::vector<double> multiples(double lo, double hi, std::uint32_t most, int digit, int exponent) {
  const double step = decimal(digit, exponent);
  const double first = std::ceil(lo / step), last = std::floor(hi / step);
  if (!(last - first < most)) return {};
  const auto count = std::uint32_t(last - first + 1); // 0 where there is none
  std::vector<double> ticks;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double tick = decimal((first + i) * digit, exponent) + 0.0; // no -0
    if (tick >= lo && tick <= hi) ticks.push_back(tick);
  }
  return ticks;
}

std::vector<double> linear_ticks(double lo, double hi, std::uint32_t most) {
  if (lo == hi) return {lo};
  const int exponent = int(std::floor(std::log10((hi - lo) / most)));
  for (int e = exponent; e <= exponent + 2; ++e)
    for (const int digit : {1, 2, 5})
      if (auto ticks = multiples(lo, hi, most, digit, e); !ticks.empty()) return ticks;
  return {};
}

/// The digits times every `stride`th power of ten.
std::vector<double> powers(double lo, double hi, std::initializer_list<int> digits, int stride) {
  std::vector<double> ticks;
  const int first = stride * int(std::floor(std::floor(std::log10(lo)) / stride));
  for (int e = first; e <= int(std::floor(std::log10(hi))); e += stride)
    for (const int digit : digits)
      if (const double tick = decimal(digit, e); tick >= lo && tick <= hi) ticks.push_back(tick);
  return ticks;
}

std::vector<double> logarithmic_ticks(double lo, double hi, std::uint32_t most) {
  std::vector<double> ticks = powers(lo, hi, {1, 2, 5}, 1);
  if (ticks.size() < 2) return linear_ticks(lo, hi, most);
  if (ticks.size() > most) ticks = powers(lo, hi, {1, 3}, 1);
  for (int stride = 1; ticks.size() > most; ++stride) ticks = powers(lo, hi, {1}, stride);
  return ticks;
}

} // namespace

double HistogramRange::edge(std::uint32_t i) const {
  if (i == 0) return lo;
  if (i >= bins) return hi;
  const double share = double(i) / bins;
  return logarithmic ? lo * std::pow(hi / lo, share) : lo + share * (hi - lo);
}

Histogram histogram_of(std::span<const float> values, const HistogramRange& range) {
  assert(range.bins > 0 && range.lo <= range.hi && (range.lo > 0 || !range.logarithmic));
  Histogram h{.range = range, .counts = std::vector<std::uint64_t>(range.bins)};
  for (const float value : values) {
    if (std::isnan(value))
      ++h.nan;
    else if (std::isinf(value))
      ++(value > 0 ? h.positive_infinite : h.negative_infinite);
    else if (value < range.lo)
      ++h.below;
    else if (value > range.hi)
      ++h.above;
    else
      ++h.counts[bin_of(value, range)];
  }
  return h;
}

HistogramRange range_of(std::span<const float> values, std::uint32_t bins, bool logarithmic) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  double lo = inf, hi = -inf;
  for (const float value : values) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) continue;
    lo = std::min(lo, double(value));
    hi = std::max(hi, double(value));
  }
  if (lo > hi) return {logarithmic ? 1.0 : 0.0, logarithmic ? 10.0 : 1.0, bins, logarithmic};
  return {lo, hi, bins, logarithmic};
}

HistogramRange whole_number_range(double lo, double hi, std::uint32_t most) {
  if (lo == hi) return {lo - 1.5, hi + 1.5, 3};
  const double width = std::ceil((hi - lo + 1) / most);
  const double bins = std::ceil((hi - lo + 1) / width);
  return {lo - 0.5, lo - 0.5 + bins * width, std::uint32_t(bins)};
}

std::vector<float> percentiles(std::span<const float> values, std::span<const double> percents) {
  std::vector<float> numbers;
  std::copy_if(values.begin(), values.end(), std::back_inserter(numbers),
               [](float value) { return !std::isnan(value); });
  std::vector<float> result;
  for (const double percent : percents) {
    if (numbers.empty()) {
      result.push_back(std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    const double rank = std::ceil(percent * double(numbers.size()) / 100) - 1;
    const auto at = numbers.begin() + std::ptrdiff_t(std::max(rank, 0.0));
    std::nth_element(numbers.begin(), at, numbers.end());
    result.push_back(*at);
  }
  return result;
}

std::vector<double> nice_ticks(double lo, double hi, std::uint32_t most, bool logarithmic) {
  if (!std::isfinite(hi - lo) || lo > hi || most == 0) return {};
  return logarithmic && lo > 0 && lo < hi ? logarithmic_ticks(lo, hi, most)
                                          : linear_ticks(lo, hi, most);
}

} // namespace lightcuts::viz
