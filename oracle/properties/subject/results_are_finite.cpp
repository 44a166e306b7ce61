// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <oracle/properties/both_sides.h>
#include <oracle/properties/bounds/worst_channel.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/sampling/cluster_odds.h>
#include <oracle/properties/shading/picture_case.h>

namespace lightcuts::oracle {
namespace {

/// With the digits that there are.
template <class Vector>
std::string text(const Vector& v) {
  return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

bool is_number(const glm::dvec3& v) { return v.x >= 0 && v.y >= 0 && v.z >= 0; }

void check_cluster(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  const glm::vec3& bound = of.bounds()[node];
  record(is_number(bound), [&] {
    const int bad = bound.x >= 0 ? bound.y >= 0 ? 2 : 1 : 0;
    return sides_text(of.at.point, of.topology(), node, bad, "true contribution",
                      of.at.truth.open(node)[std::size_t(bad)], "bound", bound[bad]);
  });
  if (!of.judged.has(Part::estimates)) return;
  const glm::dvec3& estimate = of.estimates()[node];
  record(is_number(estimate), [&] {
    return fmt::format("{}, node {}: estimate {}", of.at.text(), node, text(estimate));
  });
}

void check_cut(const CutAnswer& of, const Recorder& record) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const glm::vec3 &radiance = of.cut.radiance, &error = of.cut.certified_error;
  bool holds = is_number(radiance) && is_number(error);
  // Estimates lie below bounds, so the total can only saturate if a bound has, or the truth does.
  for (int c = 0; c < 3; ++c) holds = holds && (radiance[c] != infinity || error[c] == infinity);
  record(holds, [&] {
    return fmt::format("{}: radiance {}, certified error {}", of.point.at.text(), text(radiance),
                       text(error));
  });
}

void check_odds(const ClusterOdds& of, const Recorder& record) {
  record(std::all_of(of.p.begin(), of.p.end(), [](double p) { return p >= 0 && p <= 1; }), [&] {
    return fmt::format("{}: a probability in node {} is not in [0, 1]", of.point.at.text(),
                       of.node);
  });
}

void check_picture(const PictureCase& of, const Recorder& record) {
  of.for_each_pixel([&](glm::uvec2 pixel) {
    record(is_number(of.shown(pixel)), [&] { return of.text(pixel); });
  });
}

BothSides result_sides(const PointAnswers& of, std::uint32_t node) {
  BothSides sides = bound_sides(of, node);
  sides.must_be_finite = true;
  return sides;
}

} // namespace

const PropertyInfo property::results_are_finite{
    .name = "results-are-finite",
    .statement = "Nothing is NaN or negative.",
    .formula = "bounds, estimates, radiance, certified error, probabilities, pixels",
    .of_clusters = each_cluster<check_cluster>,
    .of_cut = check_cut,
    .of_odds = check_odds,
    .of_picture = check_picture,
    .sides = result_sides,
};

} // namespace lightcuts::oracle
