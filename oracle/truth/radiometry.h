// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include <boost/math/constants/constants.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/truth/truth.h>

/// What lights and materials are by their definitions, for any type of number: long double, whose
/// errors are looked after, and one so wide that they do not matter. Nothing here is shared with
/// the library that is judged by it.
namespace lightcuts::oracle::radiometry {

template <class Real>
using Vector = std::array<Real, 3>;

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// n.(y - x) by six exact products.
[[nodiscard]] inline Exact dot_of_floats(const glm::vec3& n, const glm::vec3& x,
                                         const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += Exact(n[i]) * (Exact(y[i]) - Exact(x[i]));
  return sum;
}

/// n.(y - x) to a few ulps. In long double: six exact products summed twice as accurately (Ogita,
/// Rump & Oishi 2005, "Accurate sum and dot product"), or in 700 bits where even that cancels.
template <class Real>
Real dot_between(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  if constexpr (!std::is_same_v<Real, long double>) {
    return Real(dot_of_floats(n, x, y));
  } else {
    long double sum = 0, lost = 0, magnitude = 0;
    for (int i = 0; i < 3; ++i)
      for (const float v : {y[i], -x[i]}) {
        const long double term = static_cast<long double>(n[i]) * v; // 48 bits
        const long double next = sum + term;
        const long double seen = next - sum;
        lost += (sum - (next - seen)) + (term - seen);
        sum = next;
        magnitude += std::abs(term);
      }
    const long double result = sum + lost;
    // The second order error is below 36 eps^2 magnitude: relative eps needs 64 eps of it left.
    constexpr long double eps = std::numeric_limits<long double>::epsilon();
    if (magnitude == 0 || std::abs(result) >= 64 * eps * magnitude) return result;
    return static_cast<long double>(dot_of_floats(n, x, y));
  }
}

template <class Real>
Vector<Real> vector_of(const glm::vec3& v) {
  return {Real(v.x), Real(v.y), Real(v.z)};
}

template <class Real>
Real length(const glm::vec3& v) {
  using std::sqrt;
  return sqrt(dot(vector_of<Real>(v), vector_of<Real>(v)));
}

template <class Real>
Real pi() {
  return boost::math::constants::pi<Real>();
}

/// Everything about the way from a point to a light, both above each other's horizon.
template <class Real>
struct Way {
  const ShadingPoint& point;
  glm::vec3 from, to;
  Vector<Real> q;
  Real distance2, distance, n_dot_l;

  Way(const ShadingPoint& p, const Light& light)
      : point(p), from(light.kind == LightKind::directional ? glm::vec3(0) : p.position()),
        to(light.position) {
    using std::sqrt;
    for (int i = 0; i < 3; ++i) q[std::size_t(i)] = Real(to[i]) - Real(from[i]);
    distance2 = dot(q, q);
    distance = sqrt(distance2);
    n_dot_l = distance2 == 0 ? Real(0) : Real(cosine_with(p.normal()));
  }
  [[nodiscard]] Real cosine_with(const glm::vec3& u) const {
    return dot_between<Real>(u, from, to) / (length<Real>(u) * distance);
  }
};

/// n.v.
template <class Real>
Real viewer_cosine(const ShadingPoint& p) {
  return dot_between<Real>(p.normal(), glm::vec3(0), p.to_viewer()) /
         (length<Real>(p.normal()) * length<Real>(p.to_viewer()));
}

/// tan^2 of the angle between the normal and l + v: what is left of l + v without its part along
/// the normal, over that part.
template <class Real>
Real half_tangent2(const Way<Real>& way) {
  const Real v_length = length<Real>(way.point.to_viewer());
  const Real n_length = length<Real>(way.point.normal());
  Vector<Real> sum, n;
  for (int i = 0; i < 3; ++i) {
    const auto k = std::size_t(i);
    sum[k] = way.q[k] / way.distance + Real(way.point.to_viewer()[i]) / v_length;
    n[k] = Real(way.point.normal()[i]) / n_length;
  }
  const Real up = way.n_dot_l + viewer_cosine<Real>(way.point);
  // |n x (l + v)| is the part along the surface.
  const Vector<Real> along = cross(n, sum);
  return dot(along, along) / (up * up);
}

/// (1 - v.h)^5 with v.h = cos(half the angle between l and v).
template <class Real>
Real schlick(const Way<Real>& way) {
  using std::sqrt;
  const glm::vec3& v = way.point.to_viewer();
  const Real cosine = way.cosine_with(v);
  const Real x = dot_between<Real>({0, -v.z, v.y}, way.from, way.to);
  const Real y = dot_between<Real>({v.z, 0, -v.x}, way.from, way.to);
  const Real z = dot_between<Real>({-v.y, v.x, 0}, way.from, way.to);
  const Real scale = length<Real>(v) * way.distance;
  const Real sine2 = (x * x + y * y + z * z) / (scale * scale);
  // 1 - cos without cancellation where the angle is acute.
  const Real versine = cosine > 0 ? Real(sine2 / (1 + cosine)) : Real(1 - cosine);
  const Real rest = versine > 2 ? Real(0) : Real(1 - versine / 2); // (v.h)^2
  const Real w = (versine / 2) / (1 + sqrt(rest));
  return w * w * w * w * w;
}

template <class Real>
Vector<Real> lobe(const NoLobe& /*lobe*/, const Way<Real>& /*way*/) {
  return {Real(0), Real(0), Real(0)};
}

template <class Real>
Vector<Real> lobe(const Phong& phong, const Way<Real>& way) {
  using std::pow;
  Vector<Real> result{Real(0), Real(0), Real(0)};
  const Real cosine = way.cosine_with(way.point.mirror());
  if (cosine <= 0) return result;
  const Real value =
      (Real(phong.exponent) + 2) / (2 * pi<Real>()) * pow(cosine, Real(phong.exponent));
  for (int c = 0; c < 3; ++c) result[std::size_t(c)] = Real(phong.reflectance[c]) * value;
  return result;
}

template <class Real>
Vector<Real> lobe(const Ward& ward, const Way<Real>& way) {
  using std::exp, std::sqrt;
  Vector<Real> result{Real(0), Real(0), Real(0)};
  const Real viewer = viewer_cosine<Real>(way.point);
  if (viewer <= 0) return result;
  const Real a2 = Real(ward.alpha) * Real(ward.alpha);
  const Real value =
      exp(-half_tangent2(way) / a2) / (4 * pi<Real>() * a2 * sqrt(way.n_dot_l * viewer));
  for (int c = 0; c < 3; ++c) result[std::size_t(c)] = Real(ward.reflectance[c]) * value;
  return result;
}

template <class Real>
Vector<Real> lobe(const CookTorrance& material, const Way<Real>& way) {
  using std::sqrt;
  Vector<Real> result{Real(0), Real(0), Real(0)};
  const Real viewer = viewer_cosine<Real>(way.point);
  if (viewer <= 0) return result;
  const Real a2 = Real(material.alpha) * Real(material.alpha);
  const Real t = half_tangent2(way);
  const Real ratio = (1 + t) / (a2 + t);
  const Real d = a2 / pi<Real>() * ratio * ratio;
  const Real l = way.n_dot_l;
  const Real v =
      1 / (2 * (l * sqrt(a2 + (1 - a2) * viewer * viewer) + viewer * sqrt(a2 + (1 - a2) * l * l)));
  const Real s = schlick(way);
  for (int c = 0; c < 3; ++c) {
    const Real f0(material.f0[c]);
    result[std::size_t(c)] = (f0 + (1 - f0) * s) * d * v;
  }
  return result;
}

/// cos(axis, x - y) - cos_outer; where that cancels, in 700 bits.
template <class Real>
Real beyond_rim(const Light& light, const ShadingPoint& point, const Real& cosine) {
  const Real rim = cosine - Real(light.cos_outer);
  if constexpr (!std::is_same_v<Real, Exact>) {
    if (rim < Real(0x1p-20) && rim > Real(-0x1p-20)) {
      const Exact dot = dot_of_floats(light.axis, light.position, point.position());
      Exact distance2 = 0;
      for (int i = 0; i < 3; ++i) {
        const Exact d = Exact(point.position()[i]) - Exact(light.position[i]);
        distance2 += d * d;
      }
      const Exact exact = dot / (length<Exact>(light.axis) * sqrt(distance2));
      return Real(Exact(exact - Exact(light.cos_outer)));
    }
  }
  return rim;
}

/// The share of its intensity that the light sends to the point.
template <class Real>
Real emission(const Light& light, const ShadingPoint& point, const Real& distance) {
  if (light.kind == LightKind::omni || light.kind == LightKind::directional) return Real(1);
  const Real cosine = dot_between<Real>(light.axis, light.position, point.position()) /
                      (length<Real>(light.axis) * distance);
  if (light.kind == LightKind::oriented) return cosine > 0 ? cosine : Real(0);
  const Real t = beyond_rim(light, point, cosine) / (Real(light.cos_inner) - Real(light.cos_outer));
  if (t <= 0) return Real(0);
  return t >= 1 ? Real(1) : Real(t * t);
}

/// Radiance towards the viewer, per channel.
template <class Real>
Vector<Real> contribution(const Light& light, const ShadingPoint& point, float min_distance) {
  Vector<Real> result{Real(0), Real(0), Real(0)};
  const Way<Real> way(point, light);
  if (way.n_dot_l <= 0) return result;
  Real common = way.n_dot_l * emission<Real>(light, point, way.distance);
  if (light.kind != LightKind::directional) {
    const Real least2 = Real(min_distance) * Real(min_distance);
    common /= way.distance2 < least2 ? least2 : way.distance2;
  }
  const Vector<Real> glossy =
      std::visit([&](const auto& l) { return lobe<Real>(l, way); }, point.material().lobe);
  for (int c = 0; c < 3; ++c) {
    const auto k = std::size_t(c);
    result[k] = (Real(point.material().diffuse[c]) / pi<Real>() + glossy[k]) * common *
                Real(light.intensity[c]);
  }
  return result;
}

} // namespace lightcuts::oracle::radiometry
