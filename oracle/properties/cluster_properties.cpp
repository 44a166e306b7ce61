// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <oracle/properties/point_properties.h>

namespace lightcuts::oracle {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

std::string describe(const ShadingPoint& point, const Topology& topology, std::uint32_t node,
                     int channel, const char* left, long double value, const char* right,
                     double limit) {
  const glm::vec3& x = point.position();
  const std::uint32_t lights = topology.light_count(node);
  return fmt::format("point ({:.9g}, {:.9g}, {:.9g}), node {} of {} light{}, channel {}: "
                     "{} {:.9g}, {} {:.9g}",
                     x.x, x.y, x.z, node, lights, lights == 1 ? "" : "s", "rgb"[channel], left,
                     static_cast<double>(value), right, limit);
}

std::string describe(const PointCase& at, std::uint32_t node, int channel, const char* left,
                     long double value, const char* right, double limit) {
  return describe(at.point, at.topology(), node, channel, left, value, right, limit);
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

/// exact(channel): the same truth as Exact.
template <class MakeExact>
Worst compared(const Wide& truth, const glm::vec3& bound, const MakeExact& exact) {
  Worst worst;
  for (int c = 0; c < 3; ++c) {
    const long double t = truth[std::size_t(c)];
    worst.add(c, dominates(bound[c], t, t * truth_error, [&] { return exact(c); }), t, bound[c]);
  }
  return worst;
}

void check_contribution(const PointCase& at, std::uint32_t node, const glm::vec3& bound,
                        Tally& tally) {
  const Worst worst =
      compared(at.truth.open(node), bound, [&](int c) { return at.truth.exact_open(node, c); });
  tally.record(Property::bound_dominates_contribution, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, worst.channel, "true contribution", worst.value, "bound",
                    bound[worst.channel]);
  });
}

void check_error(const PointCase& at, std::uint32_t node, const glm::dvec3& estimate,
                 const glm::vec3& bound, Tally& tally) {
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
    return describe(at, node, worst.channel, "true error", worst.value, "bound",
                    bound[worst.channel]);
  });
}

/// Lower bound <= truth <= upper bound, if nothing is occluded.
void check_order(const PointCase& at, std::uint32_t node, const glm::vec3& low,
                 const glm::vec3& bound, Tally& tally) {
  Worst worst;
  for (int c = 0; c < 3; ++c) {
    const long double truth = at.truth.open(node)[c];
    const long double margin = truth * truth_error;
    bool holds = low[c] <= bound[c] && low[c] <= truth + margin;
    if (holds && low[c] > truth - margin) holds = Exact(low[c]) <= at.truth.exact_open(node, c);
    worst.add(c, holds, low[c], static_cast<float>(truth));
  }
  tally.record(Property::bounds_are_ordered, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, worst.channel, "lower bound", worst.value, "true contribution",
                    static_cast<double>(at.truth.open(node)[worst.channel]));
  });
}

void check_shrinking(const PointCase& at, std::uint32_t node, std::span<const glm::vec3> bounds,
                     Tally& tally) {
  Worst worst;
  const auto nodes = at.topology().children(node);
  for (int c = 0; c < 3; ++c) {
    double children = 0;
    for (const std::uint32_t child : nodes) children += bounds[child][c];
    // Each bound may exceed the real one by bound_excess and one subnormal.
    const double allowed =
        double(bounds[node][c]) * (1 + bound_excess) + double(nodes.size()) * 0x1p-149;
    worst.add(c, children <= allowed, children, allowed);
  }
  tally.record(Property::bound_shrinks_on_refinement, worst.holds, at.place, worst.ratio, [&] {
    return describe(at, node, worst.channel, "children's bounds", worst.value, "bound",
                    bounds[node][worst.channel]);
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

/// Whether an infinite bound is excused: x in the box of the lights of one kind, or a supremum
/// beyond the largest float, for which the nearest distance with all cosines 1 has to reach half of
/// it.
bool may_be_infinite(const PointCase& at, std::uint32_t node, int channel) {
  const LightSet& lights = at.lights();
  const double min_distance2 = double(lights.min_distance()) * lights.min_distance();
  std::array<Box, light_kind_count> boxes;
  std::array<double, light_kind_count> intensity{};
  boxes.fill(Box::empty());
  for (const std::uint32_t i : at.topology().all_lights(node)) {
    const auto kind = std::size_t(lights[i].kind);
    boxes[kind].extend(lights[i].position);
    intensity[kind] += lights[i].intensity[channel];
  }
  double most = 0;
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    if (intensity[kind] == 0) continue;
    double nearest2 = 1;
    if (!is_at_infinity(LightKind(kind)))
      nearest2 =
          std::max(lightcuts::min_distance2(at.point.position(), boxes[kind]), min_distance2);
    if (nearest2 == 0) return true;
    most += intensity[kind] * largest_reflection(at.point, channel) / nearest2;
  }
  return most >= 0.5 * std::numeric_limits<float>::max();
}

void check_finite(const PointCase& at, std::uint32_t node, const glm::vec3& bound, Tally& tally) {
  const auto record = [&](Property property, auto&& is_fine) {
    int bad = -1;
    for (int c = 2; c >= 0; --c)
      if (!is_fine(c)) bad = c;
    tally.record(property, bad < 0, at.place, no_ratio, [&] {
      return describe(at, node, bad, "true contribution", at.truth.open(node)[std::size_t(bad)],
                      "bound", bound[bad]);
    });
  };
  record(Property::results_are_finite, [&](int c) { return bound[c] >= 0; });
  record(Property::bound_is_finite,
         [&](int c) { return bound[c] != infinite || may_be_infinite(at, node, c); });
}

void check_estimate(const PointCase& at, std::uint32_t node, const glm::dvec3& e, Tally& tally) {
  tally.record(
      Property::results_are_finite, e.x >= 0 && e.y >= 0 && e.z >= 0, at.place, no_ratio, [&] {
        const glm::vec3& x = at.point.position();
        return fmt::format("point ({:.9g}, {:.9g}, {:.9g}), node {}: estimate ({}, {}, {})", x.x,
                           x.y, x.z, node, e.x, e.y, e.z);
      });
}

} // namespace

void check_bound(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                 std::uint64_t place, std::uint32_t node, const glm::vec3& bound, Tally& tally) {
  const std::vector<std::uint32_t> members = topology.all_lights(node);
  Wide sum{};
  for (const std::uint32_t light : members) {
    const Wide one = contribution(lights[light], point, lights.min_distance());
    for (std::size_t c = 0; c < 3; ++c) sum[c] += one[c];
  }
  const Worst worst = compared(sum, bound, [&](int c) {
    Exact exact = 0;
    for (const std::uint32_t light : members)
      exact += exact_contribution(lights[light], point, lights.min_distance(), c);
    return exact;
  });
  tally.record(Property::bound_dominates_contribution, worst.holds, place, worst.ratio, [&] {
    return describe(point, topology, node, worst.channel, "true contribution", worst.value, "bound",
                    bound[worst.channel]);
  });
}

glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node, const PointCase& at,
                         const glm::vec3& bound) {
  const std::uint32_t index = at.topology().representative(node);
  if (index != TreeClaim::unsaid && at.visible[index] == 0) {
    const Light& light = at.lights()[index];
    const glm::vec3 from = viewed_from(light.kind, at.point.position());
    if (dot_between(at.point.normal(), from, light.position) > 0) return glm::dvec3(0);
  }
  return judged.tree.estimate(node, at.point, bound);
}

void check_cluster(const Judged& judged, std::uint32_t node, const PointCase& at,
                   std::span<const glm::vec3> bounds, Tally& tally) {
  const glm::vec3& bound = bounds[node];
  check_contribution(at, node, bound, tally);
  check_finite(at, node, bound, tally);
  if (judged.has(Part::estimates)) {
    const glm::dvec3 estimate = seen_estimate(judged, node, at, bound);
    check_estimate(at, node, estimate, tally);
    check_error(at, node, estimate, bound, tally);
  }
  if (judged.has(Part::lower_bounds))
    check_order(at, node, judged.tree.lower_bound(node, at.point), bound, tally);
  if (!at.topology().is_leaf(node)) check_shrinking(at, node, bounds, tally);
}

void check_clusters(const Judged& judged, const PointCase& at, Tally& tally) {
  if (!judged.has(Part::bounds)) return;
  std::vector<glm::vec3> bounds(at.topology().size());
  judged.tree.bounds(at.point, bounds);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) check_cluster(judged, i, at, bounds, tally);
}

} // namespace lightcuts::oracle
