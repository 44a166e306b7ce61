// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>
#include <viz/panels/picture/shown_picture.h>

namespace lightcuts::viz {

/// The colour bar of a heat map with its numbers, and how often which value occurs beside it. Its
/// ends can be dragged; a double click makes the range automatic again. Of an image: its exposure.
class Legend {
public:
  /// Fills the height that is left of the current ImGui window.
  void draw(Workbench& workbench, const ShownPicture& shown);

  /// Of the bar as it was drawn last, screen pixels; for tests.
  [[nodiscard]] const glm::dvec2& bar_origin() const { return origin_; }
  [[nodiscard]] const glm::dvec2& bar_size() const { return size_; }

private:
  void draw_bar(ColourMap map) const;
  void draw_histogram(const ShownPicture& shown);
  void draw_numbers(Layer layer, const Coloured& coloured) const;
  void drag_range(Workbench& workbench, const Coloured& coloured);
  void draw_exposure(Workbench& workbench, const Coloured& coloured) const;

  glm::dvec2 origin_{0}, size_{1};
  bool drags_top_ = false;
  // The bars of the histogram, as shares of the longest; of the picture's version.
  std::vector<float> bars_;
  std::uint64_t bars_version_ = 0;
  HeatMapScale bars_scale_;
};

} // namespace lightcuts::viz
