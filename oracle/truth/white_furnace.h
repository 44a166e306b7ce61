// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <lightcuts/core/kernels/transfer.h>
#include <oracle/truth/lobes.h>

namespace lightcuts::oracle {

template <class OneLobe>
[[nodiscard]] Material white(const OneLobe& lobe) {
  return radiometry::LobeTruth<OneLobe>::white(lobe);
}
template <class OneLobe>
[[nodiscard]] double most_reflected(const OneLobe& lobe, double viewer_cosine) {
  return radiometry::LobeTruth<OneLobe>::most_reflected(lobe, viewer_cosine);
}

/// The share of light that is reflected, and the error of that, either way.
struct Furnace {
  double value = 0, error = 0;
};

namespace detail {

/// Mean and largest value of f n.l / p, by a midpoint rule of steps x steps points.
struct MidpointRule {
  double mean = 0, largest = 0;

  template <class OneLobe>
  MidpointRule(const ShadingPoint& point, const OneLobe& lobe, int steps) {
    const typename radiometry::LobeTruth<OneLobe>::Density density(lobe, point);
    for (int i = 0; i < steps; ++i) {
      const double weight = graded((i + 1.0) / steps) - graded(double(i) / steps);
      const double x = graded((i + 0.5) / steps);
      for (int j = 0; j < steps; ++j) {
        const glm::vec3 l(density.direction({x, (j + 0.5) / steps}));
        const Sight sight(point, LightKind::directional, l);
        if (sight.below_horizon()) continue;
        const double share = reflected(point, lobe, sight, LightKind::directional, 0).x /
                             density(glm::normalize(glm::dvec3(l)));
        mean += share * weight;
        largest = std::max(largest, share);
      }
    }
    mean /= steps;
  }

private:
  /// From [0, 1] to [0, 1], slow at both ends: more points there.
  static double graded(double t) { return t * t * (3 - 2 * t); }
};

} // namespace detail

/// The integral of f n.l over the hemisphere of directions l, with all reflectances 1, for a viewer
/// at this angle (radians, below pi/2) from the normal: the share of the light from there that is
/// reflected to anywhere, and what is seen from there where light is 1 from everywhere. The
/// integrand is f n.l over a density that follows the lobe: smooth, however sharp the lobe, but for
/// a kink at the horizon. l is rounded to floats before both are evaluated. The error is estimated
/// by the difference from half the steps (an even number), which exceeds it where halving the steps
/// halves it, plus the share of the edges that no point looks at, plus 2^-20 for the rounding.
template <class OneLobe>
[[nodiscard]] Furnace white_furnace(const OneLobe& lobe, double viewer_angle, int steps = 64) {
  const Material material = white(lobe);
  const glm::vec3 v(density::around_z(std::cos(viewer_angle), 0));
  const ShadingPoint point(glm::vec3(0), {0, 0, 1}, v, material);
  const auto& white_lobe = std::get<OneLobe>(material.lobe);
  const detail::MidpointRule fine(point, white_lobe, steps), coarse(point, white_lobe, steps / 2);
  const double edges = 2 * 0.75 / (double(steps) * steps) * fine.largest;
  return {fine.mean, std::abs(fine.mean - coarse.mean) + edges + 0x1p-20 * fine.mean};
}

} // namespace lightcuts::oracle
