// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/sum_lights.h>

#include <algorithm>
#include <array>
#include <span>

#include <lightcuts/core/kernels/kind_kernel.h>

namespace lightcuts {
namespace {

constexpr std::size_t most_at_once = 64;

/// How many lights from the first on are of its kind, at most most_at_once.
std::size_t run_length(std::span<const Light> lights) {
  const auto others = std::find_if(lights.begin(), lights.end(), [&](const Light& light) {
    return light.kind != lights.front().kind;
  });
  return std::min(std::size_t(others - lights.begin()), most_at_once);
}

} // namespace

LightSum sum_lights(const LightSet& lights, const ShadingPoint& point, Visibility visible) {
  const double min_distance2 = double(lights.min_distance()) * lights.min_distance();
  const std::span<const Light> all(lights.begin(), lights.end());
  std::array<glm::dvec3, most_at_once> open;
  LightSum sum;
  for (std::size_t first = 0; first < all.size();) {
    const std::size_t count =
        run_length(all.subspan(first, std::min(most_at_once, all.size() - first)));
    kernel_of(all[first].kind)
        .transfers(point, all.subspan(first, count), min_distance2, open.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (open[i] == glm::dvec3(0)) continue;
      ++sum.shadow_rays;
      const std::size_t light = first + i;
      if (visible(std::uint32_t(light))) sum.radiance += open[i] * glm::dvec3(all[light].intensity);
    }
    first += count;
  }
  return sum;
}

} // namespace lightcuts
