// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/bounds.h>

#include <glm/geometric.hpp>

namespace lightcuts {

Box scene_bounds(const TriangleMesh& mesh) {
  Box box = Box::empty();
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner) box.extend(mesh.positions[triangle[corner]]);
  return box;
}

double diagonal_length(const Box& box) {
  if (!(box.lo.x <= box.hi.x)) return 0;
  return glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
}

} // namespace lightcuts
