// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/apportion.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lightcuts {

std::vector<std::uint32_t> apportion(std::span<const double> weights, std::uint32_t count) {
  const std::size_t size = weights.size();
  std::vector<std::size_t> ascending(size);
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::stable_sort(ascending.begin(), ascending.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] < weights[b]; });
  std::vector<double> sum_from(size + 1, 0.0); // of the weights from there on, in that order
  for (std::size_t i = size; i-- > 0;) sum_from[i] = sum_from[i + 1] + weights[ascending[i]];

  std::vector<std::uint32_t> shares(size, 1);
  // The smallest get their one. Once the smallest left is due one, all that follow are.
  std::size_t first = 0;
  while (first < size &&
         (count <= first || double(count - first) * weights[ascending[first]] < sum_from[first]))
    ++first;
  if (first == size) return shares;
  const double left = double(count) - double(first);
  double given = 0, due = 0;
  for (std::size_t i = first; i < size; ++i) {
    due += left * (weights[ascending[i]] / sum_from[first]);
    const double share = i + 1 == size ? left - given : std::floor(due + 0.5) - given;
    shares[ascending[i]] = static_cast<std::uint32_t>(std::max(1.0, share));
    given += shares[ascending[i]];
  }
  return shares;
}

std::vector<std::uint32_t> draw_stratified(std::span<const double> weights, std::uint32_t count,
                                           Random random) {
  std::vector<std::uint32_t> drawn(weights.size(), 0);
  double total = 0;
  std::size_t last = 0; // that can be drawn
  for (std::size_t i = 0; i < weights.size(); ++i) {
    total += weights[i];
    if (weights[i] > 0) last = i;
  }
  std::size_t i = 0;
  double upper = weights[0];
  for (std::uint32_t k = 0; k < count; ++k) {
    const double x = (k + random.unit_double()) / count * total;
    while (x >= upper && i < last) upper += weights[++i];
    ++drawn[i];
  }
  return drawn;
}

} // namespace lightcuts
