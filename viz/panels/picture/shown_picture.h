// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <lightcuts/core/jobs/seconds_since.h>
#include <viz/gl/context/gl_objects.h>
#include <viz/model/layers/colouring.h>
#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// A layer of a display as a texture, made anew when there is more of it.
class ShownPicture {
public:
  /// Which layer to show, and how; `exposure`: of images where none is chosen.
  struct Wish {
    DisplayMethod display;
    Layer layer = layers::image;
    std::optional<float> exposure;
    std::optional<HeatMapScale> scale = {}; ///< of heat maps, in place of what settings say
  };

  /// Takes what there is of the picture by one of the library's methods.
  void refresh(Workbench& workbench, const Wish& wish);
  /// Takes a picture from elsewhere, such as a rasterised one; version: another one, another
  /// picture.
  void refresh(const std::vector<glm::vec3>& image, glm::uvec2 size, std::uint64_t version,
               const ColourSettings& colours, std::optional<float> exposure);

  [[nodiscard]] const Coloured& coloured() const { return coloured_; }
  [[nodiscard]] const LayerValues& values() const { return values_; }
  [[nodiscard]] const Texture2D& texture() const { return texture_; }
  /// Grows with what is shown.
  [[nodiscard]] std::uint64_t version() const { return version_; }

private:
  /// While a picture grows it is shown anew at most this often, seconds.
  static constexpr double patience = 0.1;

  /// All that the texture was made from.
  struct Identity {
    std::shared_ptr<const void> frame, reference, truth, blocks;
    Layer layer = layers::image;
    ColourSettings colours;
    std::optional<float> exposure;
    std::optional<HeatMapScale> scale;
    bool operator==(const Identity&) const = default;
  };

  void show();

  Identity identity_;
  std::uint64_t source_version_ = 0, version_ = 0;
  Clock::time_point made_;
  LayerValues values_;
  Coloured coloured_;
  Texture2D texture_;
};

} // namespace lightcuts::viz
