// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <lightcuts/core/tree/cluster.h>

namespace lightcuts {

/// The ids of clusters in Morton order, by the letter: the bits of all coordinates in turn, written
/// down one after the other.
inline std::vector<std::uint32_t> naive_morton_order(const std::vector<Cluster>& clusters) {
  Box all = Box::empty(), axes = Box::empty();
  for (const Cluster& c : clusters) {
    all.extend(c.box);
    axes.extend(c.axes);
  }
  const auto scale_of = [](const Box& box, double whole) {
    double longest = 0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, double(box.hi[i]) - box.lo[i]);
    return longest > 0 ? whole / longest : 0;
  };
  const auto cell = [](const Box& of, const Box& among, int i, double scale) {
    const double centre = 0.5 * double(of.lo[i]) + 0.5 * double(of.hi[i]);
    return std::uint64_t(std::ldexp((centre - among.lo[i]) * scale, 52));
  };
  std::vector<std::pair<std::string, std::uint32_t>> keys;
  for (const Cluster& c : clusters) {
    std::string bits;
    for (int bit = 63; bit >= 0; --bit) {
      for (int i = 0; i < 3; ++i)
        bits += char('0' + ((cell(c.box, all, i, scale_of(all, 1)) >> bit) & 1));
      for (int i = 0; i < 3; ++i)
        bits += char('0' + ((cell(c.axes, axes, i, scale_of(axes, 0.25)) >> bit) & 1));
    }
    keys.emplace_back(bits, c.id);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> ids;
  for (const auto& key : keys) ids.push_back(key.second);
  return ids;
}

} // namespace lightcuts
