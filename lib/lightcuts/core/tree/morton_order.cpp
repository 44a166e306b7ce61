// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/morton_order.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace lightcuts {
namespace {

constexpr int dimensions = 6;
using Cell = std::array<std::uint64_t, dimensions>; ///< of a position and an axis

struct Key {
  Cell cell;
  Cluster cluster;
};

/// Whether a's interleaved bits are less than b's, which need not be interleaved: what decides is
/// the dimension whose bits differ first, which has the largest exclusive or (Chan 2002, "Closest-
/// point problems simplified on the RAM").
bool precedes(const Cell& a, const Cell& b) {
  int deciding = 0;
  std::uint64_t most = 0;
  for (int i = 0; i < dimensions; ++i) {
    const std::uint64_t differing = a[std::size_t(i)] ^ b[std::size_t(i)];
    // Its highest bit is above that of `most`.
    if (most < differing && most < (most ^ differing)) {
      deciding = i;
      most = differing;
    }
  }
  return a[std::size_t(deciding)] < b[std::size_t(deciding)];
}

double longest_side(const Box& box) {
  const glm::dvec3 sides = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  return std::max({sides.x, sides.y, sides.z});
}

/// value in [0, 1].
std::uint64_t cell_of(double value) { return static_cast<std::uint64_t>(value * 0x1p52); }

} // namespace

void sort_by_morton_order(std::vector<Cluster>& clusters) {
  Box all = Box::empty(), axes = Box::empty();
  for (const Cluster& c : clusters) {
    all.extend(c.box);
    axes.extend(c.axes);
  }
  const double side = longest_side(all);
  const double axis_side = longest_side(axes);
  // Opposite axes cost a union a quarter of the whole; see union_cost().
  const double position_scale = side > 0 ? 1 / side : 0;
  const double axis_scale = axis_side > 0 ? 0.25 / axis_side : 0;
  std::vector<Key> keys;
  keys.reserve(clusters.size());
  for (const Cluster& c : clusters) {
    Key key{{}, c};
    for (int i = 0; i < 3; ++i) {
      const double position = 0.5 * double(c.box.lo[i]) + 0.5 * double(c.box.hi[i]);
      const double axis = 0.5 * double(c.axes.lo[i]) + 0.5 * double(c.axes.hi[i]);
      key.cell[std::size_t(i)] = cell_of((position - double(all.lo[i])) * position_scale);
      key.cell[3 + std::size_t(i)] = cell_of((axis - double(axes.lo[i])) * axis_scale);
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    if (a.cell != b.cell) return precedes(a.cell, b.cell);
    return a.cluster.id < b.cluster.id;
  });
  for (std::size_t i = 0; i < keys.size(); ++i) clusters[i] = keys[i].cluster;
}

} // namespace lightcuts
