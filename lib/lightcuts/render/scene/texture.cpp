// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/texture.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <lightcuts/core/input_error.h>

namespace lightcuts {
namespace {

constexpr float largest_float = std::numeric_limits<float>::max();

float in_domain(float x) { return x > 0 ? std::min(x, largest_float) : 0.0F; }

/// A place between two texels along one axis.
struct Neighbours {
  std::uint32_t first, second;
  double share; ///< of the second, in [0, 1)
};

/// The texel with this index; `i` is at most one beyond the range that `reduced` maps to.
std::uint32_t wrapped(std::int64_t i, std::int64_t size, Wrap wrap) {
  if (wrap == Wrap::clamp)
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, size - 1));
  const std::int64_t period = wrap == Wrap::mirror ? 2 * size : size;
  i = (i + period) % period;
  return static_cast<std::uint32_t>(i < size ? i : period - 1 - i);
}

/// The coordinate's equal in one period, so that texels can be counted whatever its size.
double reduced(double x, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(x, 0.0, 1.0);
  const double period = wrap == Wrap::mirror ? 2 : 1;
  return x - period * std::floor(x / period);
}

Neighbours neighbours(double x, std::uint32_t size, Wrap wrap) {
  const double texel = reduced(x, wrap) * size - 0.5; // from the first texel's centre
  const double below = std::floor(texel);
  const auto i = static_cast<std::int64_t>(below);
  return {wrapped(i, size, wrap), wrapped(i + 1, size, wrap), texel - below};
}

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
  return a * (1 - share) + b * share;
}

} // namespace

Texture::Texture(glm::uvec2 size, std::vector<glm::vec3> texels)
    : size_(size), texels_(std::move(texels)) {
  if (size.x < 1 || size.y < 1 || size.x > max_texture_side || size.y > max_texture_side)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("a texture of {} x {} texels, expected 1 to {} on a side", size.x,
                                 size.y, max_texture_side));
  if (texels_.size() != std::size_t{size.x} * size.y)
    throw InputError(InputFault::inconsistent, fmt::format("{} texels for a texture of {} x {}",
                                                           texels_.size(), size.x, size.y));
  for (glm::vec3& texel : texels_) {
    const glm::vec3 kept(in_domain(texel.x), in_domain(texel.y), in_domain(texel.z));
    if (texel == kept) continue; // NaN differs
    texel = kept;
    ++clamped_;
  }
}

glm::vec3 Texture::at(const glm::dvec2& uv, const TextureWrap& wrap) const {
  const Neighbours x = neighbours(uv.x, size_.x, wrap.u);
  const Neighbours y = neighbours(uv.y, size_.y, wrap.v);
  const auto row = [&](std::uint32_t from_below) {
    const std::size_t first = std::size_t{size_.y - 1 - from_below} * size_.x;
    return between(texels_[first + x.first], texels_[first + x.second], x.share);
  };
  return glm::min(glm::vec3(between(row(y.first), row(y.second), y.share)),
                  glm::vec3(largest_float));
}

} // namespace lightcuts
