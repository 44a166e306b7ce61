// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <lightcuts/render/scene/scene.h>

#include <viz/model/layers/colour_settings.h>
#include <viz/model/layers/kinds/image.h>
#include <viz/model/picture/display_method.h>
#include <viz/model/picture/image_view.h>
#include <viz/model/picture/shading_settings.h>
#include <viz/model/scene/opened_scene.h>

namespace lightcuts::viz {

/// Everything that a person has chosen of what the window shows.
struct ViewState {
  SceneRequest open;
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

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("open", &ViewState::open, domain::inlined);
    field("method", &ViewState::display, domain::optional);
    field("compared", &ViewState::compared, domain::optional);
    field("layer", &ViewState::layer, domain::optional);
    field("split", &ViewState::split, domain::optional);
    field("split_at", &ViewState::split_at, Domain{.least = 0, .most = 1, .optional = true});
    field("pixel", &ViewState::pixel, domain::optional);
    field("node", &ViewState::node, domain::optional);
    field("step", &ViewState::step, Domain{.least = 1, .optional = true});
    field("shading", &ViewState::shading, domain::inlined);
    field("colours", &ViewState::colours, domain::inlined);
    field("image", &ViewState::image, domain::inlined);
    field("camera", &ViewState::camera, domain::optional);
  }
};

/// JSON of schema lightcuts-viz/view/2: the scene, and what is not as by default.
[[nodiscard]] std::string view_state_json(const ViewState& state);

/// Reads what view_state_json() writes. Throws InputError that names `name` and the member, where
/// the text is no JSON, of another schema or version, or a member is unknown or out of its domain.
[[nodiscard]] ViewState read_view_state(const std::string& name, const std::string& text);
/// read_view_state() of a file; throws InputError where it cannot be read, too.
[[nodiscard]] ViewState load_view_state(const std::filesystem::path& file);

} // namespace lightcuts::viz
