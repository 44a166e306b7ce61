// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include <lightcuts/error_bound.h>
#include <lightcuts/oracle/point_properties.h>

namespace lightcuts::oracle {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

std::string describe(const PointCase& at, std::uint32_t node, const TreeNode& cluster, int channel,
                     const char* left, long double value, const char* right, double limit) {
  const glm::vec3& x = at.point.position();
  return fmt::format("point ({:.9g}, {:.9g}, {:.9g}), node {} of {} light{}, channel {}: "
                     "{} {:.9g}, {} {:.9g}",
                     x.x, x.y, x.z, node, cluster.light_count, cluster.light_count == 1 ? "" : "s",
                     "rgb"[channel], left, static_cast<double>(value), right, limit);
}

/// The channel with the largest value / bound, and whether all hold.
struct Worst {
  bool holds = true;
  int channel = 0;
  double ratio = 0;
  long double value = 0;

  void add(int c, bool channel_holds, long double left, double bound) {
    const double r = bound == infinite ? 0 : ratio_of(left, bound);
    const bool first_failure = holds && !channel_holds;
    if (first_failure || (r > ratio && (holds || !channel_holds))) {
      channel = c;
      value = left;
    }
    ratio = std::max(ratio, r);
    holds = holds && channel_holds;
  }
};

void check_contribution(const PointCase& at, std::uint32_t node, const TreeNode& cluster,
                        const glm::vec3& bound, Tally& tally) {
  Worst worst;
  for (int c = 0; c < 3; ++c) {
    const long double truth = at.truth.open(node)[c];
    worst.add(c,
              dominates(bound[c], truth, truth * truth_error,
                        [&] { return at.truth.exact_open(node, c); }),
              truth, bound[c]);
  }
  tally.record(Property::bound_dominates_contribution, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, cluster, worst.channel, "true contribution", worst.value, "bound",
                    bound[worst.channel]);
  });
}

void check_error(const PointCase& at, std::uint32_t node, const TreeNode& cluster,
                 const glm::dvec3& estimate, const glm::vec3& bound, Tally& tally) {
  Worst worst;
  for (int c = 0; c < 3; ++c) {
    const long double truth = at.truth.seen(node)[c];
    const long double error = std::abs(estimate[c] - truth);
    // The subtraction rounds, too.
    const long double margin = truth * truth_error + error * truth_error;
    worst.add(c,
              dominates(bound[c], error, margin,
                        [&] { return abs(Exact(estimate[c]) - at.truth.exact_seen(node, c)); }),
              error, bound[c]);
  }
  tally.record(Property::bound_dominates_error, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, cluster, worst.channel, "true error", worst.value, "bound",
                    bound[worst.channel]);
  });
}

/// Lower bound <= truth <= upper bound, if nothing is occluded.
void check_order(const PointCase& at, std::uint32_t node, const LightTree& tree,
                 const glm::vec3& bound, Tally& tally) {
  Worst worst;
  const TreeNode& cluster = tree.node(node);
  const glm::vec3 low = contribution_lower_bound(tree, node, at.point);
  for (int c = 0; c < 3; ++c) {
    const long double truth = at.truth.open(node)[c];
    const long double margin = truth * truth_error;
    bool holds = low[c] <= bound[c] && low[c] <= truth + margin;
    if (holds && low[c] > truth - margin) holds = Exact(low[c]) <= at.truth.exact_open(node, c);
    worst.add(c, holds, low[c], static_cast<float>(truth));
  }
  tally.record(Property::bounds_are_ordered, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, cluster, worst.channel, "lower bound", worst.value,
                    "true contribution", static_cast<double>(at.truth.open(node)[worst.channel]));
  });
}

/// a and b: the children's bounds.
void check_shrinking(const PointCase& at, std::uint32_t node, const TreeNode& cluster,
                     const glm::vec3& bound, const glm::vec3& a, const glm::vec3& b, Tally& tally) {
  Worst worst;
  for (int c = 0; c < 3; ++c) {
    const double children = double(a[c]) + double(b[c]);
    // Each bound may exceed the real one by bound_excess and one subnormal.
    const double allowed = double(bound[c]) * (1 + bound_excess) + 2 * 0x1p-149;
    worst.add(c, children <= allowed, children, allowed);
  }
  tally.record(Property::bound_shrinks_on_refinement, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, cluster, worst.channel, "children's bounds", worst.value, "bound",
                    bound[worst.channel]);
  });
}

/// f n.l at most, per channel, whatever the directions.
double largest_reflection(const ShadingPoint& point, int channel) {
  const double diffuse = point.material().diffuse[channel] * std::numbers::inv_pi;
  if (point.viewer_cosine() <= 0 && !std::holds_alternative<Phong>(point.material().lobe))
    return diffuse;
  const auto largest = [&](const auto& lobe) -> double {
    using OneLobe = std::decay_t<decltype(lobe)>;
    if constexpr (std::is_same_v<OneLobe, Phong>)
      return lobe.reflectance[channel] * lobe.normalisation();
    else if constexpr (std::is_same_v<OneLobe, Ward>)
      return lobe.reflectance[channel] * lobe.peak(point.viewer_cosine());
    else if constexpr (std::is_same_v<OneLobe, CookTorrance>)
      return lobe.distribution(0) * lobe.visibility(0, point.viewer_cosine());
    else
      return 0;
  };
  return diffuse + std::visit(largest, point.material().lobe);
}

/// Whether an infinite bound is excused: x in the box, or a supremum beyond the largest float, for
/// which the nearest distance with all cosines 1 has to reach half of it.
bool may_be_infinite(const PointCase& at, const LightTree& tree, std::uint32_t node, int channel) {
  const TreeNode& cluster = tree.node(node);
  if (cluster.is_mixed())
    return may_be_infinite(at, tree, cluster.first_child, channel) ||
           may_be_infinite(at, tree, cluster.first_child + 1, channel);
  double falloff = 1;
  if (cluster.kind() != LightKind::directional) {
    const double nearest2 =
        std::max(min_distance2(at.point.position(), cluster.box), tree.min_distance2());
    if (nearest2 == 0) return true;
    falloff = 1 / nearest2;
  }
  return cluster.intensity[channel] * largest_reflection(at.point, channel) * falloff >=
         0.5 * std::numeric_limits<float>::max();
}

void check_finite(const PointCase& at, std::uint32_t node, const LightTree& tree,
                  const glm::vec3& bound, Tally& tally) {
  bool holds = true;
  int bad = 0;
  for (int c = 0; c < 3; ++c) {
    const bool fine = bound[c] >= 0 && (bound[c] < infinite || may_be_infinite(at, tree, node, c));
    if (!fine && holds) bad = c;
    holds = holds && fine;
  }
  tally.record(Property::results_are_finite, holds, at.place, no_ratio, [&] {
    return describe(at, node, tree.node(node), bad, "true contribution", at.truth.open(node)[bad],
                    "bound", bound[bad]);
  });
}

} // namespace

void check_clusters(const Subject& subject, const PointCase& at, Tally& tally) {
  const LightTree& tree = subject.tree();
  std::vector<glm::vec3> bounds(tree.nodes().size());
  for (std::uint32_t i = 0; i < bounds.size(); ++i) bounds[i] = subject.bound(i, at.point);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    const TreeNode& cluster = tree.node(i);
    const glm::vec3& bound = bounds[i];
    const glm::dvec3 estimate = seen_estimate(subject, i, at.point, bound, at.visible);
    check_contribution(at, i, cluster, bound, tally);
    check_error(at, i, cluster, estimate, bound, tally);
    check_order(at, i, tree, bound, tally);
    check_finite(at, i, tree, bound, tally);
    if (cluster.is_leaf()) continue;
    const std::uint32_t child = cluster.first_child;
    check_shrinking(at, i, cluster, bound, bounds[child], bounds[child + 1], tally);
  }
}

} // namespace lightcuts::oracle
