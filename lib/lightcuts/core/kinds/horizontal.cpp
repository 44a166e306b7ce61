// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/horizontal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <lightcuts/core/numerics/expansion.h>

namespace lightcuts::detail {
namespace {

/// Sine of the angle from a to b, times their lengths.
double turn(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 direction(const ProfileTable& table, std::size_t plane) {
  return {table.plane_cosines[plane], table.plane_sines[plane]};
}

/// Whether the angle is pi or more.
bool in_second_half(const glm::dvec2& way) { return way.y < 0 || (way.y == 0 && way.x < 0); }

/// Whether the half-plane's angle is not larger than the way's, but for rounding.
bool is_before(const glm::dvec2& plane, const glm::dvec2& way) {
  const bool plane_is_late = in_second_half(plane), way_is_late = in_second_half(way);
  return plane_is_late == way_is_late ? turn(plane, way) >= 0 : way_is_late;
}

/// The half-plane before the way, all round: of a way before the first, the last.
std::size_t plane_before(const ProfileTable& table, const glm::dvec2& way) {
  if (!is_before(direction(table, 0), way)) return table.planes() - 1;
  std::size_t first = 0, count = table.planes();
  while (count > 1) {
    const std::size_t half = count / 2;
    const bool before = is_before(direction(table, first + half), way);
    count = before ? count - half : half;
    if (before) first += half;
  }
  return first;
}

/// The half-planes beside a way, but for rounding.
Between sector_at(const ProfileTable& table, const glm::dvec2& way) {
  const std::size_t plane = plane_before(table, way), next = (plane + 1) % table.planes();
  const double weight = std::max(0.0, turn(way, direction(table, next)));
  const double next_weight = std::max(0.0, turn(direction(table, plane), way));
  if (weight + next_weight == 0) return {plane, next, 1, 0};
  return {plane, next, weight, next_weight};
}

} // namespace

HorizontalWay::HorizontalWay(const glm::vec3& axis, const glm::vec3& plane, const glm::dvec3& way) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double front = double(plane[j]) * axis[k], back = double(plane[k]) * axis[j];
    p += plane[i] * way[i];
    q += (front - back) * way[i];
    p_scale += std::abs(plane[i] * way[i]);
    q_scale += (std::abs(front) + std::abs(back)) * std::abs(way[i]);
  }
}

double HorizontalAngle::beyond(std::size_t plane) const {
  const double cosine = table_.plane_cosines[plane], sine = table_.plane_sines[plane];
  const double e = cosine * way_.q - sine * way_.p;
  // Ten roundings of 2^-53, amplified at most 2^14 times.
  if (std::abs(e) >= 0x1p-14 * (std::abs(cosine) * way_.q_scale + std::abs(sine) * way_.p_scale))
      [[likely]]
    return e;
  return exact_beyond(cosine, sine);
}

// cosine (x - y).(u x a) - sine (x - y).u. Products of two floats have 48 bits: exact in double.
double HorizontalAngle::exact_beyond(double cosine, double sine) const {
  Expansion<3 * 2 * (2 + 2 * 4)> sum;
  const auto add_times_way = [&](double factor, int i) {
    sum.add_product(factor, x_[i]);
    sum.add_product(factor, -y_[i]);
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    add_times_way(-sine * plane_[i], i);
    for (const auto& [u, a] : {std::pair(plane_[j], axis_[k]), std::pair(-plane_[k], axis_[j])}) {
      const double turned = cosine * u, product = turned * a;
      add_times_way(product, i);
      add_times_way(std::fma(turned, double(a), -product), i);
    }
  }
  return sum.rounded();
}

Between HorizontalAngle::sector() const {
  const std::size_t count = table_.planes();
  if (count == 1) return {};
  // Around from the guess, forth and back in turn.
  const std::size_t start = plane_before(table_, {way_.p, way_.q});
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t away = (step + 1) / 2;
    const std::size_t plane = (step % 2 == 1 ? start + away : start + count - away) % count;
    const std::size_t next = (plane + 1) % count;
    const double since = beyond(plane);
    if (!(since >= 0)) continue;
    const double until = -beyond(next);
    if (until > 0) return {plane, next, until, since};
  }
  return {}; // along the axis
}

HorizontalRange::HorizontalRange(const glm::vec3& axis, const glm::vec3& plane,
                                 const DifferenceBox& q) {
  for (int bits = 0; bits < 8 && !all_round_; ++bits) {
    const HorizontalWay way(axis, plane, -q.corner(bits));
    // More than what (P, Q) err by; to either side of it.
    const double error = 0x1p-48 * (way.p_scale + way.q_scale);
    const glm::dvec2 at(way.p, way.q);
    const double length = std::sqrt(at.x * at.x + at.y * at.y);
    if (!(length > 0x1p26 * error)) {
      all_round_ = true;
      return;
    }
    const glm::dvec2 aside = (error / length + soft_edge) * glm::dvec2(-at.y, at.x);
    add(at - aside);
    add(at + aside);
  }
}

// Of the directions so far, none is before begin_ or after end_.
void HorizontalRange::add(const glm::dvec2& way) {
  if (empty_) {
    begin_ = end_ = way;
    empty_ = false;
    return;
  }
  const double from_begin = turn(begin_, way), to_end = turn(way, end_);
  if (from_begin >= 0 && to_end < 0) end_ = way;
  if (from_begin < 0 && to_end >= 0) begin_ = way;
  const double ahead = begin_.x * end_.x + begin_.y * end_.y;
  if ((from_begin < 0 && to_end < 0) || ahead <= 0) all_round_ = true;
}

double HorizontalRange::max_share(const ProfileTable& table, const ProfileTable& envelope,
                                  double least, double most) const {
  if (all_round_) return detail::max_share(envelope, {}, least, most);
  const Between begin = sector_at(table, begin_), end = sector_at(table, end_);
  const std::size_t planes = (end.first + table.planes() - begin.first) % table.planes();
  const std::size_t rows = row_at(table, least) - row_at(table, most) + 2;
  if ((planes + 2) * rows > max_cells) return detail::max_share(envelope, {}, least, most);
  double share = std::max(detail::max_share(table, begin, least, most),
                          detail::max_share(table, end, least, most));
  for (std::size_t i = 1; i <= planes; ++i) {
    const std::size_t plane = (begin.first + i) % table.planes();
    share = std::max(share, detail::max_share(table, {plane, plane, 1, 0}, least, most));
  }
  return share;
}

} // namespace lightcuts::detail
