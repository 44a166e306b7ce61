// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/shading_point.h>

namespace lightcuts {

ShadingPoint::ShadingPoint(const glm::vec3& position, const glm::vec3& normal,
                           const glm::vec3& to_viewer, const Material& material)
    : ShadingFrame(position, normal, to_viewer), material_(material) {
  validate(material);
}

} // namespace lightcuts
