// SPDX-License-Identifier: MIT
#include <viz/model/picture/image_view.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace lightcuts::viz {

ImageView settled(const ImageView& view, const ScreenArea& area, glm::uvec2 image) {
  if (!view.fits) return view;
  const glm::dvec2 size = glm::max(glm::dvec2(image), glm::dvec2(1));
  const double zoom = std::min(area.size.x / size.x, area.size.y / size.y);
  return {std::clamp(zoom, min_zoom, max_zoom), 0.5 * size, true};
}

glm::dvec2 to_screen(const ImageView& view, const ScreenArea& area, const glm::dvec2& at) {
  return area.origin + 0.5 * area.size + (at - view.centre) * view.zoom;
}

glm::dvec2 to_image(const ImageView& view, const ScreenArea& area, const glm::dvec2& at) {
  return view.centre + (at - area.origin - 0.5 * area.size) / view.zoom;
}

std::optional<glm::uvec2> pixel_at(const ImageView& view, const ScreenArea& area,
                                   const glm::dvec2& screen, glm::uvec2 image) {
  const glm::dvec2 at = to_image(view, area, screen);
  if (!(at.x >= 0 && at.y >= 0 && at.x < image.x && at.y < image.y)) return std::nullopt;
  return glm::uvec2(at);
}

ImageView zoomed(const ImageView& view, const ScreenArea& area, const glm::dvec2& cursor,
                 double factor) {
  const glm::dvec2 kept = to_image(view, area, cursor);
  const double zoom = std::clamp(view.zoom * factor, min_zoom, max_zoom);
  return {zoom, kept - (cursor - area.origin - 0.5 * area.size) / zoom, false};
}

ImageView panned(const ImageView& view, const glm::dvec2& by) {
  return {view.zoom, view.centre - by / view.zoom, false};
}

ImageView one_to_one(const ImageView& view) { return {1, view.centre, false}; }

} // namespace lightcuts::viz
