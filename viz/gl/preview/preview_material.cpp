// SPDX-License-Identifier: MIT
#include <viz/gl/preview/preview_material.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace lightcuts::viz {
namespace {

/// What each lobe becomes.
struct Conversion {
  glm::vec3 diffuse;

  PreviewMaterial operator()(const NoLobe& /*none*/) const { return {diffuse, glm::vec3(0), 0}; }
  PreviewMaterial operator()(const CookTorrance& lobe) const {
    return {diffuse, lobe.f0, lobe.alpha};
  }
  PreviewMaterial operator()(const Phong& lobe) const {
    return nearest(lobe.reflectance, std::sqrt(2 / (lobe.exponent + 2)));
  }
  PreviewMaterial operator()(const Ward& lobe) const {
    return nearest(lobe.reflectance, lobe.alpha);
  }

private:
  [[nodiscard]] PreviewMaterial nearest(const glm::vec3& reflectance, float alpha) const {
    return {diffuse, glm::clamp(reflectance, 0.0F, 1.0F),
            std::clamp(alpha, CookTorrance::min_alpha, 1.0F)};
  }
};

} // namespace

PreviewMaterial preview_material(const Material& material) {
  return std::visit(Conversion{material.diffuse}, material.lobe);
}

} // namespace lightcuts::viz
