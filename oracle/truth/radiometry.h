// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <variant>

#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/truth/kinds.h>
#include <oracle/truth/lobes.h>
#include <oracle/truth/way.h>

namespace lightcuts::oracle::radiometry {

/// The share of its intensity that the light sends to the point.
template <class Real>
Real emission(const Light& light, const ShadingPoint& point, const Real& distance) {
  return with_kind(light.kind, [&](auto truth) -> Real {
    return truth.emission(light, point.position(), distance);
  });
}

/// Radiance towards the viewer, per channel, of a surface of this material; the way is that from
/// the point to the light.
template <class Real>
Vector<Real> contribution(const Light& light, const Way<Real>& way, const Material& material,
                          float min_distance) {
  const ShadingPoint& point = way.point;
  Vector<Real> result{Real(0), Real(0), Real(0)};
  if (way.n_dot_l <= 0) return result;
  Real common = way.n_dot_l * emission<Real>(light, point, way.distance);
  if (!is_far(light.kind)) {
    const Real least2 = Real(min_distance) * Real(min_distance);
    common /= way.distance2 < least2 ? least2 : way.distance2;
  }
  const Vector<Real> glossy =
      std::visit([&](const auto& l) { return lobe(l, way); }, material.lobe);
  for (int c = 0; c < 3; ++c) {
    const auto k = std::size_t(c);
    result[k] =
        (Real(material.diffuse[c]) / pi<Real>() + glossy[k]) * common * Real(light.intensity[c]);
  }
  return result;
}

/// Radiance towards the viewer, per channel.
template <class Real>
Vector<Real> contribution(const Light& light, const ShadingPoint& point, float min_distance) {
  return contribution(light, Way<Real>(point, light), point.material(), min_distance);
}

} // namespace lightcuts::oracle::radiometry
