// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <variant>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <oracle/properties/both_sides.h>
#include <oracle/properties/bounds/worst_channel.h>
#include <oracle/truth/lobes.h>

namespace lightcuts::oracle {
namespace {

/// f n.l at most, per channel, whatever the directions.
double largest_reflection(const ShadingPoint& point, int channel) {
  return point.material().diffuse[channel] * std::numbers::inv_pi +
         std::visit(
             [&]<class OneLobe>(const OneLobe& lobe) {
               return radiometry::LobeTruth<OneLobe>::largest(lobe, point.viewer_cosine(), channel);
             },
             point.material().lobe);
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

void check_finite(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  const glm::vec3& bound = of.bounds()[node];
  int bad = -1;
  for (int c = 2; c >= 0; --c)
    if (bound[c] == std::numeric_limits<float>::infinity() && !may_be_infinite(of.at, node, c))
      bad = c;
  record(bad < 0, [&] {
    return sides_text(of.at.point, of.topology(), node, bad, "true contribution",
                      of.at.truth.open(node)[std::size_t(bad)], "bound", bound[bad]);
  });
}

BothSides finite_sides(const PointAnswers& of, std::uint32_t node) {
  BothSides sides = bound_sides(of, node);
  sides.must_be_finite = true;
  return sides;
}

} // namespace

const PropertyInfo property::bound_is_finite{
    .name = "bound-is-finite",
    .statement =
        "A bound is infinite only where the point is among the lights, or the largest float "
        "might be exceeded.",
    .formula = "bound < inf unless the point is in the box, or all lights at the nearest distance, "
               "mirrored straight to the viewer, reach half the largest float",
    .severity = Severity::waste,
    .needs = only(Part::bounds),
    .of_clusters = each_cluster<check_finite>,
    .sides = finite_sides,
};

} // namespace lightcuts::oracle
