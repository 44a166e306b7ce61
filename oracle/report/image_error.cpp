// SPDX-License-Identifier: MIT
#include <oracle/report/image_error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lightcuts::oracle {
namespace {

/// value / what errors of pixel i are relative to. What is only the rounding of 0 counts as 0; NaN
/// (of infinities) as infinite.
double relative(double value, const glm::vec3& reference, double black_level) {
  if (value <= 3 * 0x1p-149) return 0;
  const double ratio = value / std::max(channel_sum(reference), 3 * black_level);
  return std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
}

/// |v - r|; two saturated values are alike.
double difference(float v, float r) { return v == r ? 0 : std::abs(double(v) - double(r)); }

double pixel_error(const glm::vec3& v, const glm::vec3& r, double black_level) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += difference(v[c], r[c]);
  return relative(sum, r, black_level);
}

} // namespace

std::vector<float> relative_errors(const Rendering& picture, const Rendering& reference,
                                   double black_level) {
  std::vector<float> errors(reference.radiance.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] =
        static_cast<float>(pixel_error(picture.radiance[i], reference.radiance[i], black_level));
  return errors;
}

ImageError compare(const Rendering& picture, const Rendering& reference, double threshold,
                   double black_level) {
  ImageError error;
  double squares = 0;
  double relative_squares = 0;
  double sum = 0;
  for (std::size_t i = 0; i < reference.radiance.size(); ++i) {
    if (reference.cut_size[i] == 0) continue;
    const glm::vec3& v = picture.radiance[i];
    const glm::vec3& r = reference.radiance[i];
    const double e = pixel_error(v, r, black_level);
    error.mean += e;
    error.max = std::max(error.max, e);
    error.mean_certified += relative(channel_sum(picture.certified_error[i]), r, black_level);
    error.pixels_over_threshold += e > threshold ? 1 : 0;
    for (int c = 0; c < 3; ++c) {
      if (!std::isfinite(r[c])) continue; // no mean would survive it
      const double d = difference(v[c], r[c]);
      squares += d * d;
      relative_squares += d * d / ((r[c] + 0.01) * (r[c] + 0.01));
      sum += r[c];
    }
  }
  if (reference.surface_pixels == 0) return error;
  const double pixels = double(reference.surface_pixels);
  error.mean /= pixels;
  error.mean_certified /= pixels;
  error.mrse = relative_squares / (3 * pixels);
  if (sum > 0) error.rel_rmse = std::sqrt(squares / (3 * pixels)) / (sum / (3 * pixels));
  return error;
}

} // namespace lightcuts::oracle
