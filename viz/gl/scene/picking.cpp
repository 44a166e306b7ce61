// SPDX-License-Identifier: MIT
#include <viz/gl/scene/picking.h>

#include <glm/geometric.hpp>
#include <lightcuts/render/scene/bounds.h>

namespace lightcuts::viz {
namespace {

/// Keeps the best of the points it is offered.
class Pick {
public:
  Pick(const ViewFrame& frame, glm::uvec2 size, const glm::dvec2& mouse, double radius)
      : frame_(frame), size_(size), mouse_(mouse), pixels_(radius) {}

  void offer(std::size_t index, const glm::dvec3& point) {
    const auto place = screen_position(frame_, size_, point);
    if (!place) return;
    const double pixels = glm::distance(*place, mouse_);
    const double depth = glm::dot(point - frame_.origin, frame_.forward);
    if (!(pixels < pixels_ || (pixels == pixels_ && (!best_ || depth < depth_)))) return;
    best_ = index;
    pixels_ = pixels;
    depth_ = depth;
  }
  [[nodiscard]] std::optional<std::size_t> best() const { return best_; }

private:
  const ViewFrame& frame_;
  glm::uvec2 size_;
  glm::dvec2 mouse_;
  double pixels_, depth_ = 0;
  std::optional<std::size_t> best_;
};

} // namespace

std::optional<std::size_t> pick_point(const ViewFrame& frame, glm::uvec2 size,
                                      std::span<const glm::dvec3> points, const glm::dvec2& mouse,
                                      double radius) {
  Pick pick(frame, size, mouse, radius);
  for (std::size_t i = 0; i < points.size(); ++i) pick.offer(i, points[i]);
  return pick.best();
}

glm::dvec3 shown_position(const Light& light, const Box& scene) {
  if (!is_at_infinity(light.kind)) return light.position;
  const double diagonal = diagonal_length(scene);
  if (diagonal == 0) return light.position;
  return 0.5 * (glm::dvec3(scene.lo) + glm::dvec3(scene.hi)) +
         diagonal * glm::dvec3(light.position);
}

} // namespace lightcuts::viz
