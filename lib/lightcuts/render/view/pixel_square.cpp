// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/pixel_square.h>

#include <utility>

#include <glm/common.hpp>
#include <lightcuts/render/shafts/shaft_prover.h>

namespace lightcuts {

PixelSquare::PixelSquare(const SceneView& view, glm::uvec2 pixel) {
  const glm::uvec2 lo = pixel / side * side, hi = glm::min(lo + side, view.size());
  for (unsigned y = lo.y; y < hi.y; ++y)
    for (unsigned x = lo.x; x < hi.x; ++x) {
      auto p = view.at({x, y});
      if (!p) continue;
      pixels.emplace_back(x, y);
      points.push_back({p->point, {x, y}});
      seen.push_back(std::move(*p));
    }
  if (!pixels.empty()) query = std::uint64_t(pixels.front().y) * view.size().x + pixels.front().x;
}

std::vector<glm::vec3> PixelSquare::ray_origins() const {
  std::vector<glm::vec3> origins;
  for (const VisiblePoint& p : seen) origins.push_back(p.ray_origin);
  return origins;
}

std::vector<PixelResult> light(const PixelSquare& square, const SceneView& view,
                               PointLighter& lighter) {
  std::vector<PixelResult> results(square.pixels.size());
  const auto visible = [&](std::uint32_t p, std::uint32_t light) {
    return view.casts_to(square.seen[p], light);
  };
  ShaftProver proven(view.triangles(), square.ray_origins());
  lighter.light_all(square.points, square.query, {visible, &proven}, results);
  return results;
}

} // namespace lightcuts
