// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/material.h>
#include <lightcuts/core/shading/shading_frame.h>

namespace lightcuts {

/// A point of a surface, seen from one direction, and what it is made of.
class ShadingPoint : public ShadingFrame {
public:
  /// Throws InputError as ShadingFrame does, and where the material is out of its domain.
  ShadingPoint(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& to_viewer,
               const Material& material);

  [[nodiscard]] const Material& material() const { return material_; }

private:
  Material material_;
};

} // namespace lightcuts
