// SPDX-License-Identifier: MIT
#include <viz/gl/scene/camera_lines.h>

#include <array>

#include <viz/gl/scene/view_frame.h>

namespace lightcuts::viz {

std::vector<ColouredLine> camera_lines(const Camera& camera, glm::uvec2 size, double depth,
                                       const Rgba8& colour) {
  const ViewFrame frame = view_frame(camera, size);
  const auto point = [&](double x, double y) {
    return glm::vec3(frame.origin + depth * (frame.forward + x * frame.half.x * frame.right +
                                             y * frame.half.y * frame.up));
  };
  const std::array corners{point(-1, -1), point(1, -1), point(1, 1), point(-1, 1)};
  std::vector<ColouredLine> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back({glm::vec3(frame.origin), corners[i], colour, 2});
    lines.push_back({corners[i], corners[(i + 1) % 4], colour, 2});
  }
  lines.push_back({point(-0.2, 1), point(0, 1.3), colour, 2});
  lines.push_back({point(0, 1.3), point(0.2, 1), colour, 2});
  return lines;
}

} // namespace lightcuts::viz
