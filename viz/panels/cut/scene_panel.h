// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <viz/gl/scene/orbit_camera.h>
#include <viz/gl/scene/scene_picture.h>
#include <viz/model/cut/cut_overlay.h>
#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// The scene in three dimensions: geometry, lights, the selected shading point, and the clusters of
/// its cut as boxes.
class ScenePanel {
public:
  /// Fills what is left of the current ImGui window. Needs an open scene.
  void draw(Workbench& workbench);

private:
  /// All that a picture is drawn from: it is drawn again only where that differs.
  struct Drawn {
    glm::uvec2 size{0};
    Camera camera, traced;
    std::shared_ptr<const InspectionResult> inspection;
    std::optional<std::uint32_t> node;
    int colour_by = 0;
    bool boxes = true, lines = true;
    bool operator==(const Drawn&) const = default;
  };

  /// Makes the picture anew where it has to be; what goes wrong becomes failure_.
  void update_picture(Workbench& workbench, glm::uvec2 size);
  void adopt(const Workbench& workbench, glm::uvec2 size);
  void draw_options();
  void draw_legend(const Workbench& workbench) const;
  void render(Workbench& workbench, glm::uvec2 size);
  void handle_mouse(Workbench& workbench, const glm::dvec2& origin, glm::uvec2 size);
  void pick(Workbench& workbench, const glm::dvec2& at, glm::uvec2 size) const;
  [[nodiscard]] Overlay overlay_for(Workbench& workbench) const;

  std::shared_ptr<const OpenedScene> scene_;
  std::unique_ptr<ScenePicture> picture_;
  OrbitCamera camera_;
  OverlayOptions options_;
  std::optional<Drawn> drawn_;
  std::string failure_; ///< why the scene cannot be drawn, or nothing
};

} // namespace lightcuts::viz
