// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <lightcuts/render/view/renderer.h>

namespace lightcuts::oracle {

/// How far a picture v is from the reference r, over the pixels that see a surface (cut_size > 0):
///   relative error of a pixel = sum_c |v_c - r_c| / max(sum_c r_c, 3 black_level)
///   rel_rmse = sqrt(mean_{pixels, c} (v - r)^2) / mean_{pixels, c} r
///   mrse = mean_{pixels, c} (v - r)^2 / (r + 0.01)^2, in the scene's units of radiance
/// Where picture and reference both exceed the largest float they count as equal, and stay out of
/// the squares.
struct ImageError {
  double mean = 0, max = 0; ///< of the relative error
  double rel_rmse = 0;
  double mrse = 0;
  double mean_certified = 0; ///< of sum_c certified_c over the same denominator
  std::uint64_t pixels_over_threshold = 0;
};

[[nodiscard]] inline double channel_sum(const glm::vec3& v) { return double(v.x) + v.y + v.z; }

/// Pictures of the same scene and size.
[[nodiscard]] ImageError compare(const Rendering& picture, const Rendering& reference,
                                 double threshold, double black_level);

/// The relative error of each pixel; 0 where it sees no surface.
[[nodiscard]] std::vector<float> relative_errors(const Rendering& picture,
                                                 const Rendering& reference, double black_level);

} // namespace lightcuts::oracle
