// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/point_case.h>
#include <oracle/truth/reciprocity.h>

namespace lightcuts::oracle {
namespace {

void check_reciprocity(const ShadingPoint& point, const Light& light, const Recorder& record) {
  const glm::vec3 &n = point.normal(), &v = point.to_viewer();
  const glm::dvec3 q =
      glm::dvec3(light.position) - glm::dvec3(viewed_from(light.kind, point.position()));
  const double distance = glm::length(q);
  if (!(distance > 0)) return;
  const glm::vec3 l(q / distance);
  if (dot_between(n, glm::vec3(0), l) <= 0 || point.viewer_cosine() <= 0) return;
  const BothWays f = both_ways(point.material(), n, l, v);
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double difference = std::abs(f.there[c] - f.back[c]);
    holds = holds && difference <= f.allowed[c];
    worst = std::max(worst, ratio_of(difference, f.allowed[c]));
  }
  record(holds, worst, [&] {
    return fmt::format("n {}, l {}, v {}: f n.l n.v {} there, {} back", digits_of(n), digits_of(l),
                       digits_of(v), digits_of(f.there), digits_of(f.back));
  });
}

} // namespace

const PropertyInfo property::brdf_is_reciprocal{
    .name = "brdf-is-reciprocal",
    .statement = "A surface reflects as much from l to v as from v to l.",
    .formula = "|f(l,v) - f(v,l)| n.l n.v <= rounding of both, per channel",
    .of_light = check_reciprocity,
};

} // namespace lightcuts::oracle
