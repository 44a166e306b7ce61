// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/visible_share.h>

#include <algorithm>

#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

/// Sums over the points that have looked at a cluster.
struct Moments {
  int lookers = 0;
  double count = 0, seen = 0;
  glm::dvec2 place{0}, seen_place{0};
  double xx = 0, xy = 0, yy = 0;

  void add(const glm::dvec2& p, double weight, bool sees) {
    ++lookers;
    count += weight;
    place += weight * p;
    xx += weight * p.x * p.x;
    xy += weight * p.x * p.y;
    yy += weight * p.y * p.y;
    if (!sees) return;
    seen += weight;
    seen_place += weight * p;
  }
};

VisibleShare::Plane plane_of(const Moments& m) {
  constexpr int fewest = 8; // that a slope is taken from
  const double mean = m.count > 0 ? m.seen / m.count : 1;
  if (m.seen == 0 || m.seen == m.count || m.lookers < fewest) return {mean, glm::dvec2(0)};
  const glm::dvec2 centre = m.place / m.count;
  const double xx = m.xx - m.count * centre.x * centre.x;
  const double xy = m.xy - m.count * centre.x * centre.y;
  const double yy = m.yy - m.count * centre.y * centre.y;
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 0x1p-10 * xx * yy) return {mean, glm::dvec2(0)}; // all but on one line
  const glm::dvec2 moment = m.seen_place - m.seen * centre;
  const glm::dvec2 slope =
      glm::dvec2(yy * moment.x - xy * moment.y, xx * moment.y - xy * moment.x) / determinant;
  return {mean - glm::dot(slope, centre), slope};
}

} // namespace

void VisibleShare::start(std::span<const glm::vec2> places) {
  places_.clear();
  for (const glm::vec2& place : places)
    places_.push_back(glm::dvec2(place) - glm::dvec2(places.front()));
  fitted_.clear();
}

VisibleShare::Plane VisibleShare::fit(const BlockEvidence& evidence, std::size_t place,
                                      std::uint32_t node) {
  if (fitted_.size() <= place) fitted_.resize(place + 1);
  Fitted& fitted = fitted_[place];
  const std::uint32_t lookers = evidence.lookers(place, node);
  if (fitted.node == node && fitted.lookers == lookers) return fitted.plane;
  const auto weight = [&](std::uint32_t p) {
    return evidence.has_looked(place, node, p) ? evidence.weight(place, p) : 0.0;
  };
  double most = 0;
  for (std::uint32_t p = 0; p < places_.size(); ++p) most = std::max(most, weight(p));
  Moments moments;
  for (std::uint32_t p = 0; p < places_.size(); ++p)
    if (weight(p) > 0) moments.add(places_[p], weight(p) / most, evidence.sees(place, p));
  fitted = {node, lookers, plane_of(moments)};
  return fitted.plane;
}

double VisibleShare::at(const Plane& plane, std::uint32_t point) const {
  return std::clamp(plane.height + glm::dot(plane.slope, places_[point]), 0.0, 1.0);
}

} // namespace lightcuts
