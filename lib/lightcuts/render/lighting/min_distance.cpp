// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/min_distance.h>

#include <cmath>
#include <numbers>

#include <lightcuts/render/scene/triangle.h>

namespace lightcuts {

float suggested_min_distance(const TriangleMesh& mesh, std::size_t count) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += Triangle(mesh, i).area();
  return static_cast<float>(std::sqrt(area / (std::numbers::pi * static_cast<double>(count))));
}

} // namespace lightcuts
