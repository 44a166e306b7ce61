// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/visible_share.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

double sum_of(const glm::dvec3& rgb) { return rgb.x + rgb.y + rgb.z; }

} // namespace

/// Sums over the points that have looked at a cluster.
struct VisibleShare::Sums {
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

VisibleShare::Plane VisibleShare::plane_of(const Sums& m) const {
  constexpr int fewest = 8; // that a slope is taken from
  const double mean = m.count > 0 ? m.seen / m.count : 1;
  if (m.seen == 0 || m.seen == m.count) return {.height = mean};
  const Plane level{.height = mean, .agreed = false};
  if (m.lookers < fewest) return level;
  const glm::dvec2 centre = m.place / m.count;
  const double xx = m.xx - m.count * centre.x * centre.x;
  const double xy = m.xy - m.count * centre.x * centre.y;
  const double yy = m.yy - m.count * centre.y * centre.y;
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 0x1p-10 * xx * yy) return level; // all but on one line
  const glm::dvec2 moment = m.seen_place - m.seen * centre;
  const glm::dvec2 slope =
      glm::dvec2(yy * moment.x - xy * moment.y, xx * moment.y - xy * moment.x) / determinant;
  return {mean - glm::dot(slope, centre), slope, false};
}

void VisibleShare::start(std::span<const glm::vec2> places) {
  places_.clear();
  for (const glm::vec2& place : places)
    places_.push_back(glm::dvec2(place) - glm::dvec2(places.front()));
  alike_.assign(places.size() * places.size(), 1);
  influence_.assign(places.size() * places.size(), 0);
}

double VisibleShare::on(const Plane& plane, std::uint32_t point) const {
  return std::clamp(plane.height + glm::dot(plane.slope, places_[point]), 0.0, 1.0);
}

void VisibleShare::observe(const BlockEvidence& evidence, std::span<const CutChain::Link> clusters,
                           std::span<const std::uint32_t> points) {
  planes_.assign(clusters.size(), {});
  weights_.assign(clusters.size() * places_.size(), 0);
  residuals_.assign(clusters.size() * places_.size(), 0);
  for (std::size_t place = 0; place < clusters.size(); ++place)
    fit(evidence, place, clusters[place]);
  compare(evidence, points);
  smooth(points);
}

void VisibleShare::fit(const BlockEvidence& evidence, std::size_t place,
                       const CutChain::Link& cluster) {
  const std::size_t count = places_.size();
  float* const weights = &weights_[place * count];
  double most = 0;
  for (std::uint32_t p = 0; p < count; ++p)
    if (evidence.has_looked(place, cluster.node, p))
      most = std::max(most, evidence.weight(place, p));
  Sums sums;
  if (most > 0)
    for (std::uint32_t p = 0; p < count; ++p) {
      if (!evidence.has_looked(place, cluster.node, p)) continue;
      const double weight = evidence.weight(place, p) / most;
      weights[p] = float(weight);
      if (weight > 0) sums.add(places_[p], weight, evidence.sees(place, p));
    }
  const Plane plane = planes_[place] = plane_of(sums);
  if (plane.agreed) return;
  for (std::uint32_t p = 0; p < count; ++p)
    if (weights[p] > 0)
      residuals_[place * count + p] = float((evidence.sees(place, p) ? 1.0 : 0.0) - on(plane, p));
}

/// Of two points, the sum over clusters of light (s_p - s_q)^2, s their true shares, is estimated
/// without bias by
///   light ((v_p - v_q)^2 - s_p (1 - s_p) - s_q (1 - s_q)),
/// v what the points saw, 0 or 1, and the plane's shares taken in the place of s; in that of v,
/// too, where a point has not asked. They are alike unless that is larger than the deviation it has
/// of points whose shares are the same.
void VisibleShare::compare(const BlockEvidence& evidence, std::span<const std::uint32_t> points) {
  const std::size_t count = places_.size();
  products_.assign(count * count, 0);
  excess_.assign(count, 0);
  double variance = 0, all_light = 0;
  for (std::size_t place = 0; place < planes_.size(); ++place) {
    double light = 0;
    for (const std::uint32_t p : points) light += sum_of(evidence.open(place, p));
    light /= double(points.size());
    all_light += light;
    if (!planes_[place].agreed) variance += compare_at(place, light, points);
  }
  const double deviation = std::sqrt(variance) + 0x1p-9 * all_light;
  if (deviation == 0) return;
  for (const std::uint32_t p : points)
    for (const std::uint32_t q : points) {
      if (p == q) continue;
      const double apart = excess_[p] + excess_[q] - 2 * double(products_[p * count + q]);
      const double over = std::max(0.0, apart / deviation - 1);
      alike_[p * count + q] = float(std::exp(-0.5 * over * over));
    }
}

double VisibleShare::compare_at(std::size_t place, double light,
                                std::span<const std::uint32_t> points) {
  const std::size_t count = places_.size();
  const Plane& plane = planes_[place];
  double own = 0, lookers = 0;
  seen_.assign(count, 0);
  for (const std::uint32_t p : points) {
    const double s = on(plane, p);
    seen_[p] = float(s) + residuals_[place * count + p];
    excess_[p] += light * double(seen_[p]) * seen_[p];
    if (weights_[place * count + p] == 0) continue;
    own += s * (1 - s);
    lookers += 1;
    excess_[p] -= light * s * (1 - s);
  }
  for (const std::uint32_t p : points) {
    const float scaled = float(light) * seen_[p];
    if (scaled == 0) continue;
    float* const row = &products_[p * count];
    for (std::size_t q = 0; q < count; ++q) row[q] += scaled * seen_[q];
  }
  const double differ = lookers > 0 ? 2 * own / lookers : 0; // that two see something else
  return light * light * differ * (1 - differ);
}

/// Of each point, by how much each other's residual raises its share: the value there of the plane
/// fitted to residuals, those weighted that are alike. Slopes are drawn to 0, as they are when few
/// points speak for them.
void VisibleShare::smooth(std::span<const std::uint32_t> points) {
  constexpr double ridge = 20; // square pixels
  const std::size_t count = places_.size();
  for (const std::uint32_t p : points) {
    double all = 0, xx = ridge, xy = 0, yy = ridge;
    glm::dvec2 centre(0);
    for (std::size_t q = 0; q < count; ++q) {
      all += alike_[p * count + q];
      centre += double(alike_[p * count + q]) * places_[q];
    }
    centre /= all; // the point is like itself
    for (std::size_t q = 0; q < count; ++q) {
      const double w = alike_[p * count + q];
      const glm::dvec2 d = places_[q] - centre;
      xx += w * d.x * d.x;
      xy += w * d.x * d.y;
      yy += w * d.y * d.y;
    }
    const glm::dvec2 to = places_[p] - centre;
    const double determinant = xx * yy - xy * xy;
    const glm::dvec2 along = glm::dvec2(yy * to.x - xy * to.y, xx * to.y - xy * to.x) / determinant;
    for (std::size_t q = 0; q < count; ++q)
      influence_[q * count + p] =
          float(double(alike_[p * count + q]) * (1 / all + glm::dot(along, places_[q] - centre)));
  }
}

void VisibleShare::at(std::size_t place, std::span<const std::uint32_t> points,
                      std::span<float> shares) {
  const Plane& plane = planes_[place];
  if (plane.agreed) {
    std::ranges::fill(shares, float(plane.height));
    return;
  }
  const std::size_t count = places_.size();
  const std::span<const float> weights(&weights_[place * count], count);
  // Those who drew lights that matter less speak less, as for the plane.
  const float mean = std::accumulate(weights.begin(), weights.end(), 0.0F) /
                     float(count - std::size_t(std::ranges::count(weights, 0.0F)));
  raised_.assign(count, 0);
  for (std::size_t q = 0; q < count; ++q) {
    const float residual = weights[q] / mean * residuals_[place * count + q];
    if (residual == 0) continue;
    const float* const row = &influence_[q * count];
    for (std::size_t p = 0; p < count; ++p) raised_[p] += row[p] * residual;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    shares[i] = std::clamp(float(on(plane, points[i])) + raised_[points[i]], 0.0F, 1.0F);
}

} // namespace lightcuts
