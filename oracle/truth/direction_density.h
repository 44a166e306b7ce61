// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <lightcuts/core/lobes/shading_point.h>

/// For each lobe a map from the unit square to directions l of light, and their density p(l), which
/// is about that of f n.l. The normal is (0, 0, 1); l and v are unit vectors. Written without the
/// lobes' own formulas.
namespace lightcuts::oracle {

namespace density {

inline constexpr double pi = std::numbers::pi;

/// The direction at these cylindrical coordinates around the z axis.
inline glm::dvec3 around_z(double cosine, double angle) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

/// tan^2 of the angle between h, of any length, and the z axis.
inline double tangent2(const glm::dvec3& h) { return (h.x * h.x + h.y * h.y) / (h.z * h.z); }

inline glm::dvec3 mirrored(const glm::dvec3& v, const glm::dvec3& h) {
  return 2 * glm::dot(v, h) * h - v;
}

inline glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

} // namespace density

/// p = n.l / pi.
class CosineDensity {
public:
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
    return density::around_z(std::sqrt(at.x), 2 * density::pi * at.y);
  }
  [[nodiscard]] double operator()(const glm::dvec3& l) const { return l.z / density::pi; }
};

/// p = (m + 1) cos(r,l)^m / (2 pi).
class PhongDensity {
public:
  PhongDensity(const ShadingFrame& frame, double exponent)
      : r_(density::unit(frame.mirror())), side_{r_.z, 0, -r_.x}, m_(exponent) {
    side_ = glm::normalize(side_); // the viewer is in the plane y = 0
  }
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
    const double versine = -std::expm1(std::log(at.x) / (m_ + 1)); // 1 - cos(r,l)
    const double sine = std::sqrt(versine * (2 - versine));
    const double angle = 2 * density::pi * at.y;
    return (1 - versine) * r_ +
           sine * (std::cos(angle) * side_ + std::sin(angle) * glm::cross(r_, side_));
  }
  [[nodiscard]] double operator()(const glm::dvec3& l) const {
    const double cosine = glm::dot(r_, l);
    return cosine <= 0 ? 0 : (m_ + 1) / (2 * density::pi) * std::pow(cosine, m_);
  }

private:
  glm::dvec3 r_, side_;
  double m_;
};

/// The slopes of h have a normal distribution: with dl = 4 v.h dh,
/// p = exp(-tan^2(n,h) / alpha^2) / (4 pi alpha^2 cos^3(n,h) v.h).
class GaussianSlopeDensity {
public:
  GaussianSlopeDensity(const ShadingFrame& frame, double alpha)
      : v_(density::unit(frame.to_viewer())), alpha_(alpha) {}
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
    const double slope = alpha_ * std::sqrt(-std::log(at.x));
    const glm::dvec3 h =
        density::around_z(1 / std::sqrt(1 + slope * slope), 2 * density::pi * at.y);
    // Mirrored at the back of h there is no light.
    return glm::dot(v_, h) <= 0 ? glm::dvec3(0, 0, -1) : density::mirrored(v_, h);
  }
  [[nodiscard]] double operator()(const glm::dvec3& l) const {
    const glm::dvec3 h = glm::normalize(v_ + l);
    const double a2 = alpha_ * alpha_;
    return std::exp(-density::tangent2(h) / a2) /
           (4 * density::pi * a2 * h.z * h.z * h.z * glm::dot(v_, h));
  }

private:
  glm::dvec3 v_;
  double alpha_;
};

/// h is one of the normals of a GGX surface that v sees (Heitz 2018; the map is that of Dupuy and
/// Benyoub 2023): p = G1 D / (4 n.v).
class VisibleNormalDensity {
public:
  VisibleNormalDensity(const ShadingFrame& frame, double alpha)
      : v_(density::unit(frame.to_viewer())),
        stretched_(glm::normalize(glm::dvec3(alpha * v_.x, alpha * v_.y, v_.z))), alpha_(alpha) {}
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
    const double z = at.x * (1 + stretched_.z) - stretched_.z;
    const glm::dvec3 sum = density::around_z(z, 2 * density::pi * at.y) + stretched_;
    const glm::dvec3 h = glm::normalize(glm::dvec3(alpha_ * sum.x, alpha_ * sum.y, sum.z));
    return density::mirrored(v_, h);
  }
  [[nodiscard]] double operator()(const glm::dvec3& l) const {
    const double a2 = alpha_ * alpha_, t = density::tangent2(v_ + l);
    const double ratio = (1 + t) / (a2 + t);
    const double masked = v_.z + std::sqrt(a2 + (1 - a2) * v_.z * v_.z); // 2 n.v / G1
    return a2 * ratio * ratio / (2 * density::pi * masked);
  }

private:
  glm::dvec3 v_, stretched_;
  double alpha_;
};

// Which one a lobe is integrated with.
inline CosineDensity density_for(const NoLobe& /*lobe*/, const ShadingFrame& /*frame*/) {
  return {};
}
inline PhongDensity density_for(const Phong& phong, const ShadingFrame& frame) {
  return {frame, phong.exponent};
}
inline GaussianSlopeDensity density_for(const Ward& ward, const ShadingFrame& frame) {
  return {frame, ward.alpha};
}
inline VisibleNormalDensity density_for(const CookTorrance& lobe, const ShadingFrame& frame) {
  return {frame, lobe.alpha};
}

} // namespace lightcuts::oracle
