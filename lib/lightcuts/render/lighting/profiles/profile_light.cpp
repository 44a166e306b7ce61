// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/profiles/profile_light.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <lightcuts/core/kinds/luminaire.h>
#include <lightcuts/core/lights/profile_envelope.h>
#include <lightcuts/core/numerics/rounding.h>

#include <lightcuts/render/lighting/circle.h>
#include <lightcuts/render/lighting/direction_sampling.h>

namespace lightcuts {
namespace {

/// The angle from half-plane i to k, radians.
double angle_between_planes(const ProfileTable& table, std::size_t i, std::size_t k) {
  const glm::dvec2 a(table.plane_cosines[i], table.plane_sines[i]);
  const glm::dvec2 b(table.plane_cosines[k], table.plane_sines[k]);
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// Mean over the horizontal angles, for each row. Along a chord the mean is that of its ends.
std::vector<double> means_of_rows(const ProfileTable& table) {
  std::vector<double> means(table.rows());
  const std::size_t count = table.planes();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = (i + 1) % count;
    const double turns =
        count == 1 ? 1 : angle_between_planes(table, i, k) / (2 * std::numbers::pi);
    for (std::size_t row = 0; row < table.rows(); ++row)
      means[row] += turns * 0.5 * (double(table.share(i, row)) + table.share(k, row));
  }
  return means;
}

double height(const ProfileTable& table, std::size_t row) {
  return double(table.cosines[row]) - table.cosines[row + 1];
}

} // namespace

std::optional<glm::vec3> plane_beside(const glm::vec3& axis, const glm::vec3& plane) {
  const glm::dvec3 a = glm::normalize(glm::dvec3(axis)), p(plane);
  const glm::dvec3 beside = p - glm::dot(p, a) * a;
  if (!(glm::length(beside) > 1e-3)) return std::nullopt;
  return glm::vec3(glm::normalize(beside));
}

glm::vec3 usual_plane(const glm::vec3& axis) {
  for (const glm::vec3& along : {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)})
    if (const auto beside = plane_beside(axis, along)) return *beside;
  return {0, 1, 0};
}

glm::vec3 scaled_intensity(const glm::vec3& colour, double peak) {
  const glm::dvec3 scaled = glm::dvec3(colour) * peak;
  return {to_float(scaled.x), to_float(scaled.y), to_float(scaled.z)};
}

double solid_share(const ProfileTable& table) {
  const std::vector<double> means = means_of_rows(table);
  double sum = 0;
  for (std::size_t row = 0; row + 1 < table.rows(); ++row)
    sum += height(table, row) * 0.5 * (means[row] + means[row + 1]);
  return 2 * std::numbers::pi * sum;
}

glm::dvec3 profile_direction(const Light& light, const glm::dvec2& u, Random& random) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(light.axis));
  const Profile envelope = envelope_of(light.profile);
  const ProfileTable& most = envelope.table();
  const auto ceiling = [&](std::size_t row) {
    return double(std::max(most.shares[row], most.shares[row + 1]));
  };
  double total = 0;
  for (std::size_t row = 0; row + 1 < most.rows(); ++row) total += height(most, row) * ceiling(row);
  if (total == 0) return axis;
  Light at_origin = light;
  at_origin.position = glm::vec3(0);
  double choice = u.x, turns = u.y;
  for (;;) {
    double left = choice * total;
    std::size_t row = 0;
    while (row + 2 < most.rows() && left >= height(most, row) * ceiling(row)) {
      left -= height(most, row) * ceiling(row);
      ++row;
    }
    if (ceiling(row) > 0) {
      const double within = std::clamp(left / (height(most, row) * ceiling(row)), 0.0, 1.0);
      const glm::dvec3 d = at_cosine(axis, most.cosines[row] - within * height(most, row), turns);
      if (random.unit_double() * ceiling(row) < Luminaire::emission(at_origin, glm::vec3(d)))
        return d;
    }
    choice = random.unit_double();
    turns = random.unit_double();
  }
}

const Profile& street_luminaire() {
  static const Profile profile = [] {
    // Every 22.5 degrees down to the horizon and around.
    constexpr std::array<std::array<float, 5>, 4> columns{{{0.25F, 0.375F, 0.5F, 0.625F, 0},
                                                           {0.25F, 0.375F, 0.75F, 1, 0.03125F},
                                                           {0.25F, 0.25F, 0.375F, 0.5F, 0},
                                                           {0.25F, 0.125F, 0.0625F, 0, 0}}};
    constexpr std::array<int, 16> around{0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 2, 2, 2, 1, 1};
    ProfileTable table{{}, {}, {}, {}};
    const auto at = [](double turns) {
      const glm::dvec2 d = on_unit_circle(turns);
      return glm::vec2(std::abs(d.x) < 0x1p-40 ? 0 : d.x, std::abs(d.y) < 0x1p-40 ? 0 : d.y);
    };
    for (std::size_t row = 0; row < 5; ++row) table.cosines.push_back(at(double(row) / 16).x);
    for (const float dark : {-0x1p-20F, -1.0F}) table.cosines.push_back(dark);
    for (std::size_t i = 0; i < around.size(); ++i) {
      table.plane_cosines.push_back(at(double(i) / 16).x);
      table.plane_sines.push_back(at(double(i) / 16).y);
      for (const float share : columns[std::size_t(around[i])]) table.shares.push_back(share);
      table.shares.insert(table.shares.end(), 2, 0.0F);
    }
    return Profile(table);
  }();
  return profile;
}

} // namespace lightcuts
