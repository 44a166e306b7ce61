// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/textured_emitter.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/scene/triangle.h>

namespace lightcuts {
namespace {

constexpr double most_cells = 0x1p26;  // between texels' centres: some seconds
constexpr double most_pieces = 0x1p20; // kept; more cells share one
constexpr int subdivisions = 512;      // of each side, where cells would be too many

using Polygon = std::vector<glm::dvec2>;

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The part of a convex polygon where sign * p[axis] >= sign * limit (Sutherland & Hodgman 1974).
Polygon clipped(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a[axis] - limit), to = sign * (b[axis] - limit);
    if (from >= 0) result.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      glm::dvec2 cut = a + (b - a) * (from / (from - to));
      cut[axis] = limit;
      result.push_back(cut);
    }
  }
  return result;
}

Polygon between(const Polygon& polygon, int axis, double lo, double hi) {
  return clipped(clipped(polygon, axis, lo, 1), axis, hi, -1);
}

/// The smallest and the largest coordinate.
std::pair<double, double> range_of(const Polygon& polygon, int axis) {
  double lo = polygon[0][axis], hi = lo;
  for (const glm::dvec2& p : polygon) {
    lo = std::min(lo, p[axis]);
    hi = std::max(hi, p[axis]);
  }
  return {lo, hi};
}

/// Integrals of 1, x, y and x y over a polygon.
struct Moments {
  double one = 0, x = 0, y = 0, xy = 0;

  Moments(const Polygon& polygon, const glm::dvec2& origin) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[0] - origin, b = polygon[i] - origin,
                       c = polygon[i + 1] - origin, sum = a + b + c;
      const double area = 0.5 * std::abs(cross2(b - a, c - a));
      one += area;
      x += area * sum.x / 3;
      y += area * sum.y / 3;
      xy += area * (sum.x * sum.y + a.x * a.y + b.x * b.y + c.x * c.y) / 12;
    }
  }
};

/// The bits of both numbers in turn (Morton 1966): neighbours in the order are close.
std::uint64_t interleaved(std::uint32_t column, std::uint32_t row) {
  std::uint64_t result = 0;
  for (int bit = 0; bit < 32; ++bit)
    result |= std::uint64_t(column >> bit & 1) << (2 * bit) | std::uint64_t(row >> bit & 1)
                                                                  << (2 * bit + 1);
  return result;
}

/// A uniform point of a convex polygon.
glm::dvec2 point_in(const Polygon& polygon, Random& random) {
  double left = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    left += std::abs(cross2(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]));
  left *= random.unit_double();
  glm::dvec2 weights = square_to_triangle({random.unit_double(), random.unit_double()});
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::dvec2 b = polygon[i] - polygon[0], c = polygon[i + 1] - polygon[0];
    left -= std::abs(cross2(b, c));
    if (left <= 0 || i + 2 == polygon.size()) return polygon[0] + b * weights.x + c * weights.y;
  }
  return polygon.empty() ? glm::dvec2(1.0 / 3) : polygon[0];
}

std::int64_t floor_to_whole(double x) { return static_cast<std::int64_t>(std::floor(x)); }

} // namespace

TexturedEmitter::TexturedEmitter(const Scene& scene, std::uint32_t triangle)
    : texture_(
          scene.textures[scene.surfaces[scene.mesh.surface[triangle]].emission_texture->index]),
      wrap_(scene.surfaces[scene.mesh.surface[triangle]].emission_texture->wrap),
      emission_(scene.surfaces[scene.mesh.surface[triangle]].emission),
      area_(Triangle(scene.mesh, triangle).area()) {
  const glm::uvec3 t = scene.mesh.triangles[triangle];
  for (int i = 0; i < 3; ++i)
    corners_[i] = glm::dvec2(scene.mesh.emission_uv[t[i]]) * glm::dvec2(texture_.size()) - 0.5;
  doubled_texels_ = cross2(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  const glm::dvec2 extent = glm::max(glm::max(corners_[0], corners_[1]), corners_[2]) -
                            glm::min(glm::min(corners_[0], corners_[1]), corners_[2]);
  // A triangle meets at most so many cells, in a texture of up to 2^53 repeats.
  const double cells = std::abs(doubled_texels_) / 2 + 2 * (extent.x + extent.y) + 2;
  const double farthest =
      std::max({glm::length(corners_[0]), glm::length(corners_[1]), glm::length(corners_[2])});
  approximate_ = !(cells <= most_cells && farthest < 0x1p40 &&
                   std::abs(doubled_texels_) > 0x1p-40 * farthest * farthest);
  if (extent == glm::dvec2(0)) {
    approximate_ = false;
    pieces_.push_back({0, 0, 0, area_ * radiance_at(corners_[0])});
    side_ = 0;
  } else if (approximate_) {
    add_subdivision();
  } else {
    while (cells / double(side_ * side_) > most_pieces) side_ *= 2;
    add_cells();
  }
  for (const Piece& piece : pieces_) intensity_ += piece.intensity;
}

glm::dvec3 TexturedEmitter::radiance_at(const glm::dvec2& texel) const {
  return emission_ * glm::dvec3(texture_.at((texel + 0.5) / glm::dvec2(texture_.size()), wrap_));
}

void TexturedEmitter::add_cells() {
  const Polygon whole{corners_[0], corners_[1], corners_[2]};
  const auto [lo, hi] = range_of(whole, 1);
  for (std::int64_t row = floor_to_whole(lo); double(row) < hi; ++row)
    if (const Polygon strip = between(whole, 1, double(row), double(row) + 1); strip.size() > 2)
      add_row(row, strip);
  // Cells of one square, which come in several rows, are one piece.
  std::ranges::stable_sort(pieces_, {}, &Piece::order);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (kept > 0 && pieces_[kept - 1].order == pieces_[i].order)
      pieces_[kept - 1].intensity += pieces_[i].intensity;
    else
      pieces_[kept++] = pieces_[i];
  }
  pieces_.resize(kept);
}

void TexturedEmitter::add_row(std::int64_t row, const Polygon& strip) {
  const auto [lo, hi] = range_of(strip, 0);
  const double scale = 2 * area_ / std::abs(doubled_texels_); // m^2 per texel
  const std::int64_t first_row =
      floor_to_whole(std::min({corners_[0].y, corners_[1].y, corners_[2].y}));
  const std::int64_t first_column =
      floor_to_whole(std::min({corners_[0].x, corners_[1].x, corners_[2].x}));
  std::optional<Piece> last;
  for (std::int64_t column = floor_to_whole(lo); double(column) < hi; ++column) {
    const Polygon cell = between(strip, 0, double(column), double(column) + 1);
    if (cell.size() < 3) continue;
    const glm::dvec2 corner(column, row);
    const Moments m(cell, corner);
    const glm::dvec3 c00 = radiance_at(corner), c10 = radiance_at(corner + glm::dvec2(1, 0)),
                     c01 = radiance_at(corner + glm::dvec2(0, 1)),
                     c11 = radiance_at(corner + glm::dvec2(1, 1));
    const glm::dvec3 integral =
        c00 * (m.one - m.x - m.y + m.xy) + c10 * (m.x - m.xy) + c01 * (m.y - m.xy) + c11 * m.xy;
    // What cancels could leave less than 0.
    const glm::dvec3 intensity = scale * glm::max(integral, glm::dvec3(0));
    if (!(mean(intensity) > 0)) continue;
    const std::int64_t square_row = (row - first_row) / side_,
                       square_column = (column - first_column) / side_;
    const std::uint64_t order = interleaved(static_cast<std::uint32_t>(square_column),
                                            static_cast<std::uint32_t>(square_row));
    if (last && last->order == order) {
      last->intensity += intensity;
      continue;
    }
    if (last) pieces_.push_back(*last);
    last = Piece{order, first_column + square_column * side_, first_row + square_row * side_,
                 intensity};
  }
  if (last) pieces_.push_back(*last);
}

/// Equal triangles, each with the radiance at its centre. `column` counts along a row, two to a
/// step, `row` from the first corner's side.
void TexturedEmitter::add_subdivision() {
  side_ = 0;
  const double share = area_ / (double(subdivisions) * subdivisions);
  for (std::int64_t row = 0; row < subdivisions; ++row)
    for (std::int64_t column = 0; column < 2 * (subdivisions - row) - 1; ++column) {
      Piece piece{0, column, row, glm::dvec3(0)};
      const Polygon t = outline(piece);
      const glm::dvec2 centre = (t[0] + t[1] + t[2]) / 3.0;
      piece.order =
          2 * interleaved(static_cast<std::uint32_t>(column / 2), static_cast<std::uint32_t>(row)) +
          static_cast<std::uint64_t>(column % 2);
      piece.intensity = share * radiance_at(corners_[0] + (corners_[1] - corners_[0]) * centre.x +
                                            (corners_[2] - corners_[0]) * centre.y);
      if (mean(piece.intensity) > 0) pieces_.push_back(piece);
    }
  std::ranges::stable_sort(pieces_, {}, &Piece::order);
}

/// In barycentric coordinates.
Polygon TexturedEmitter::outline(const Piece& piece) const {
  if (side_ > 0) {
    Polygon polygon{corners_[0], corners_[1], corners_[2]};
    polygon = between(polygon, 1, double(piece.row), double(piece.row + side_));
    polygon = between(polygon, 0, double(piece.column), double(piece.column + side_));
    for (glm::dvec2& p : polygon) p = barycentric(p);
    return polygon;
  }
  if (!approximate_) return {{0, 0}, {1, 0}, {0, 1}};
  const double x = double(piece.column / 2), y = double(piece.row), n = subdivisions;
  if (piece.column % 2 == 0) return {{x / n, y / n}, {(x + 1) / n, y / n}, {x / n, (y + 1) / n}};
  return {{(x + 1) / n, y / n}, {(x + 1) / n, (y + 1) / n}, {x / n, (y + 1) / n}};
}

glm::dvec2 TexturedEmitter::barycentric(const glm::dvec2& texel) const {
  const glm::dvec2 p = texel - corners_[0];
  const double b = cross2(p, corners_[2] - corners_[0]) / doubled_texels_;
  const double c = cross2(corners_[1] - corners_[0], p) / doubled_texels_;
  // Rounding may leave the triangle.
  const double in_b = std::clamp(b, 0.0, 1.0);
  return {in_b, std::clamp(c, 0.0, 1 - in_b)};
}

std::vector<TexturedEmitter::Sample> TexturedEmitter::samples(std::uint32_t count,
                                                              Random random) const {
  std::vector<Sample> result;
  if (pieces_.empty()) return result;
  double total = 0;
  for (const Piece& piece : pieces_) total += mean(piece.intensity);
  result.reserve(count);
  std::size_t i = 0;
  double left = mean(pieces_[0].intensity); // of piece i, for lights to come
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool last = k + 1 == count; // takes what rounding has left
    double wanted = total / count, before_point = wanted * random.unit_double();
    std::size_t chosen = std::min(i, pieces_.size() - 1);
    glm::dvec3 intensity(0);
    while (i < pieces_.size() && (last || wanted > 0)) {
      const double part = last ? left : std::min(left, wanted);
      intensity += pieces_[i].intensity * (part / mean(pieces_[i].intensity));
      if (before_point >= 0) chosen = i;
      before_point -= part;
      wanted -= part;
      left -= part;
      if (left <= 0 && ++i < pieces_.size()) left = mean(pieces_[i].intensity);
    }
    result.push_back({point_in(outline(pieces_[chosen]), random), intensity});
  }
  return result;
}

} // namespace lightcuts
