// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <viz/gl/preview/raster_preview.h>
#include <viz/gl/scene/orbit_camera.h>
#include <viz/panels/picture/shown_picture.h>

namespace lightcuts::viz {

/// The picture: shows the layer of the method chosen, and a second one beside the split; lets
/// people zoom, pan, select pixels and move the camera.
class ImagePanel {
public:
  /// Fills what is left of the current ImGui window. Needs an open scene.
  void draw(Workbench& workbench);

  /// Of the last draw(): where on the screen the image's area was, and the view as it was shown.
  [[nodiscard]] const ScreenArea& area() const { return area_; }
  [[nodiscard]] const ImageView& view() const { return view_; }
  [[nodiscard]] std::optional<glm::uvec2> hovered() const { return hovered_; }
  /// The picture left of the split, or the whole.
  [[nodiscard]] const ShownPicture& shown() const { return shown_; }
  /// The picture right of the split.
  [[nodiscard]] const ShownPicture& compared() const { return compared_; }
  /// While held, the reference is shown.
  void flip(bool held) { flipped_ = held; }
  /// Whether the rasterised picture, if any is shown, has all lights.
  [[nodiscard]] bool raster_complete() const { return !raster_shown_ || raster_done_; }
  /// Lights of the rasterised picture that are in, 0 to 1.
  [[nodiscard]] float raster_share() const { return raster_ ? raster_->share() : 0; }

private:
  void refresh(Workbench& workbench);
  void refresh_raster(Workbench& workbench, ShownPicture& into);
  void refresh_one(Workbench& workbench, const DisplayMethod& display,
                   const std::optional<HeatMapScale>& scale, ShownPicture& into);
  void handle_mouse(Workbench& workbench);
  void handle_zoom(Workbench& workbench);
  void move_camera(Workbench& workbench);
  void click(Workbench& workbench);
  void draw_pictures(Workbench& workbench);
  void draw_pixel_values(Workbench& workbench);
  void draw_block(const Workbench& workbench);
  void draw_selection(const Workbench& workbench);
  void draw_split(Workbench& workbench);
  void draw_tooltip(Workbench& workbench);
  void remember_exposure(Workbench& workbench);

  ScreenArea area_;
  ImageView view_;
  std::optional<glm::uvec2> hovered_;
  ShownPicture shown_, compared_;
  bool flipped_ = false, dragging_split_ = false;

  // One exposure for all methods, so that they can be compared.
  std::optional<float> exposure_;
  std::shared_ptr<const OpenedScene> exposure_of_;
  bool exposure_final_ = false;

  std::unique_ptr<RasterPreview> raster_;
  std::shared_ptr<const OpenedScene> raster_of_;
  std::optional<Camera> raster_camera_;
  bool raster_done_ = false, raster_shown_ = false;
  std::vector<glm::vec3> raster_image_;
  std::uint64_t raster_version_ = 0;
  std::string failure_;               ///< the last one that was told
  std::optional<OrbitCamera> moving_; ///< while the camera is being moved
};

} // namespace lightcuts::viz
