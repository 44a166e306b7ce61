// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/ies/ies_table.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/vec2.hpp>
#include <lightcuts/render/lighting/circle.h>

namespace lightcuts {
namespace {

constexpr double widest_row = 2.5, widest_sector = 22.5; // degrees

/// What a table has at some angles.
struct HalfPlane {
  double angle; ///< degrees
  std::vector<double> column;
};

/// Adds what lies between two angles, linear, in as many equal steps as `widest` wants, and the
/// second.
template <class Add>
void add_steps(double from, double to, double widest, const Add& add) {
  const int steps = std::max(1, int(std::ceil((to - from) / widest)));
  for (int i = 1; i < steps; ++i) add(from + (to - from) * i / steps, double(i) / steps);
  add(to, 1.0);
}

std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double t) {
  if (t == 1) return b;
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = (1 - t) * a[i] + t * b[i];
  return result;
}

/// The half-planes of the file and their mirror images, once around: angles from 0 to 360, both
/// ends included.
std::vector<HalfPlane> all_around(const Candela& candela, Symmetry symmetry) {
  std::vector<HalfPlane> planes;
  const auto add = [&](double angle, std::size_t i) {
    planes.push_back({angle, candela.columns[i]});
  };
  const std::size_t count = candela.horizontal.size();
  const auto& h = candela.horizontal;
  for (std::size_t i = 0; i < count; ++i) {
    if (symmetry == Symmetry::across) {
      add(h[i], i);
      add(h[i] <= 180 ? 180 - h[i] : 540 - h[i], i);
      continue;
    }
    add(h[i], i);
    if (symmetry == Symmetry::quadrant) {
      add(180 - h[i], i);
      add(180 + h[i], i);
    }
    if (symmetry == Symmetry::quadrant || symmetry == Symmetry::bilateral) add(360 - h[i], i);
    if (symmetry == Symmetry::none_unclosed && i == 0) add(360, i);
  }
  if (symmetry == Symmetry::across) { // the half-plane at 180 is that at 0, too
    for (std::size_t i = 0; i < count; ++i)
      if (h[i] == 180) add(360, i);
  }
  std::sort(planes.begin(), planes.end(), [](auto& a, auto& b) { return a.angle < b.angle; });
  const auto same = [](auto& a, auto& b) { return a.angle == b.angle; };
  planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
  return planes;
}

/// Without sectors wider than widest_sector; the last, at 360, left out.
std::vector<HalfPlane> narrowed(const std::vector<HalfPlane>& planes) {
  std::vector<HalfPlane> all{planes.front()};
  for (std::size_t i = 1; i < planes.size(); ++i)
    add_steps(planes[i - 1].angle, planes[i].angle, widest_sector, [&](double angle, double t) {
      all.push_back({angle, mixed(planes[i - 1].column, planes[i].column, t)});
    });
  all.pop_back();
  return all;
}

glm::dvec2 on_circle(double degrees) { return on_unit_circle(degrees / 360); }

/// Cosine and sine as floats that are 0 where they should be.
glm::vec2 direction_at(double degrees) {
  const glm::dvec2 d = on_circle(degrees);
  return {std::abs(d.x) < 0x1p-40 ? 0.0F : float(d.x), std::abs(d.y) < 0x1p-40 ? 0.0F : float(d.y)};
}

constexpr std::size_t dark = SIZE_MAX;

/// Where rows go: the file's, and those between.
struct Row {
  std::size_t next;   ///< the file's row that follows or is meant; dark: none
  double next_weight; ///< 1: that row itself
  float cosine;
};

/// Angles that are nearer to each other than floats tell are one.
std::vector<Row> rows_between(const std::vector<double>& vertical) {
  std::vector<Row> rows{{0, 1, direction_at(vertical.front()).x}};
  for (std::size_t i = 1; i < vertical.size(); ++i)
    add_steps(vertical[i - 1], vertical[i], widest_row, [&](double angle, double t) {
      const float cosine = direction_at(angle).x;
      if (cosine < rows.back().cosine) rows.push_back({i, t, cosine});
    });
  return rows;
}

/// From 1 to -1: black where the file has no angles, from 2^-20 of the cosine beyond them on.
std::vector<Row> rows_of(const std::vector<double>& vertical) {
  constexpr float edge = 0x1p-20F;
  std::vector<Row> rows = rows_between(vertical);
  if (const float first = rows.front().cosine; first < 1) {
    if (first + edge < 1) rows.insert(rows.begin(), {dark, 1, first + edge});
    rows.insert(rows.begin(), {dark, 1, 1});
  }
  if (const float last = rows.back().cosine; last > -1) {
    if (last - edge > -1) rows.push_back({dark, 1, last - edge});
    rows.push_back({dark, 1, -1});
  }
  return rows;
}

double at_row(const std::vector<double>& column, const Row& row) {
  if (row.next == dark) return 0;
  if (row.next_weight == 1) return column[row.next];
  return (1 - row.next_weight) * column[row.next - 1] + row.next_weight * column[row.next];
}

} // namespace

double Candela::peak() const {
  double most = 0;
  for (const auto& column : columns)
    for (const double value : column) most = std::max(most, value);
  return most;
}

ProfileTable table_of(const Candela& candela, Symmetry symmetry) {
  const bool alike =
      std::all_of(candela.columns.begin(), candela.columns.end(),
                  [&](const auto& column) { return column == candela.columns.front(); });
  std::vector<HalfPlane> planes{{0, candela.columns.front()}};
  if (symmetry != Symmetry::round && !alike) planes = narrowed(all_around(candela, symmetry));
  const std::vector<Row> rows = rows_of(candela.vertical);
  const double peak = candela.peak();
  ProfileTable table{{}, {}, {}, {}};
  for (const Row& row : rows) table.cosines.push_back(row.cosine);
  for (const HalfPlane& plane : planes) {
    const glm::vec2 direction = direction_at(plane.angle);
    table.plane_cosines.push_back(direction.x);
    table.plane_sines.push_back(direction.y);
    for (const Row& row : rows)
      table.shares.push_back(peak == 0 ? 0.0F
                                       : std::min(1.0F, float(at_row(plane.column, row) / peak)));
  }
  return table;
}

} // namespace lightcuts
