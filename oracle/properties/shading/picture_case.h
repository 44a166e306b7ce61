// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_view.h>
#include <oracle/cases/case.h>
#include <oracle/properties/properties.h>

namespace lightcuts::oracle {

/// A subject's picture of a case's triangles, made when first asked for.
class PictureCase {
public:
  PictureCase(const Subject& subject, const Case& on, const SceneView& view);

  template <class F>
  void for_each_pixel(F&& f) const {
    for (unsigned y = 0; y < view_.size().y; ++y)
      for (unsigned x = 0; x < view_.size().x; ++x) f(glm::uvec2(x, y));
  }
  [[nodiscard]] glm::vec3 shown(glm::uvec2 pixel) const;
  /// What a cut gives for the point that the pixel sees.
  [[nodiscard]] glm::vec3 expected(glm::uvec2 pixel) const;
  /// Both.
  [[nodiscard]] std::string text(glm::uvec2 pixel) const;

private:
  const Subject& subject_;
  const SceneView& view_;
  LightTree tree_;
  CutConfig config_;
  mutable CutSelector select_;
  mutable std::optional<Rendering> picture_;
};

} // namespace lightcuts::oracle
