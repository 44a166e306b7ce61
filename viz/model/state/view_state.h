// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <lightcuts/render/io/images/colour_map.h>
#include <lightcuts/render/scene/scene.h>

#include <viz/model/layers/kinds/image.h>
#include <viz/model/picture/display_method.h>
#include <viz/model/picture/image_view.h>
#include <viz/model/scene/opened_scene.h>
#include <viz/model/state/shading_settings.h>

namespace lightcuts::viz {

/// How values become colours.
struct ColourSettings {
  ColourMap map = ColourMap::inferno;
  bool logarithmic = false;
  bool automatic_range = true;
  float lo = 0, hi = 1;          ///< where not automatic; lo < hi, and 0 < lo if logarithmic
  std::optional<float> exposure; ///< of images: a factor; nothing: automatic_exposure()

  bool operator==(const ColourSettings&) const = default;
};

/// Everything that a person has chosen of what the window shows.
struct ViewState {
  OpenRequest open;
  DisplayMethod display = methods::lightcuts;
  DisplayMethod compared = methods::reference; ///< right of the split
  Layer layer = layers::image;
  bool split = false;
  float split_at = 0.5F;             ///< share of the image's area that is left of it
  std::optional<glm::uvec2> pixel;   ///< selected
  std::optional<std::uint32_t> node; ///< selected cluster
  std::optional<std::uint32_t> step; ///< of the refinement; nothing: its end
  ShadingSettings shading;
  ColourSettings colours;
  ImageView image;
  std::optional<Camera> camera; ///< nothing: the scene's own

  bool operator==(const ViewState&) const = default;
};

/// JSON of schema lightcuts-viz/view/1; optional values that are not there are left out.
[[nodiscard]] std::string view_state_json(const ViewState& state);

/// Reads that. Throws InputError that names `name` and the member, where the text is no JSON, of
/// another schema or version, or a member is unknown or out of its domain.
[[nodiscard]] ViewState read_view_state(const std::string& name, const std::string& text);
[[nodiscard]] ViewState load_view_state(const std::filesystem::path& file);

} // namespace lightcuts::viz
