// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <lightcuts/core/records/fields.h>

namespace lightcuts::viz {

inline constexpr double min_zoom = 1.0 / 64, max_zoom = 256;

/// Which part of an image is shown where: zoom screen pixels per image pixel, with the image's
/// point `centre` (pixels, (0, 0) its upper left corner) in the middle of the area.
struct ImageView {
  double zoom = 1; ///< within [min_zoom, max_zoom]
  glm::dvec2 centre{0};
  bool fits = true; ///< the whole image, as large as the area allows; follows its size

  bool operator==(const ImageView&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    constexpr Domain zoom{.least = min_zoom, .most = max_zoom, .optional = true};
    field("fits", &ImageView::fits, domain::optional);
    field("zoom", &ImageView::zoom, zoom);
    field("centre", &ImageView::centre, domain::optional);
  }
};

/// An area of the screen, pixels.
struct ScreenArea {
  glm::dvec2 origin{0}; ///< upper left corner
  glm::dvec2 size{1};
};

/// The view with zoom and centre as they are in this area: of one that fits, those that do.
[[nodiscard]] ImageView settled(const ImageView& view, const ScreenArea& area, glm::uvec2 image);

/// Screen position of a point of the image, and the other way round. The view is settled.
[[nodiscard]] glm::dvec2 to_screen(const ImageView& view, const ScreenArea& area,
                                   const glm::dvec2& at);
[[nodiscard]] glm::dvec2 to_image(const ImageView& view, const ScreenArea& area,
                                  const glm::dvec2& at);

/// The pixel of the image there, if any.
[[nodiscard]] std::optional<glm::uvec2> pixel_at(const ImageView& view, const ScreenArea& area,
                                                 const glm::dvec2& screen, glm::uvec2 image);

/// Zoomed by the factor, with what is under the cursor staying there. The view is settled.
[[nodiscard]] ImageView zoomed(const ImageView& view, const ScreenArea& area,
                               const glm::dvec2& cursor, double factor);
/// Moved by so many screen pixels.
[[nodiscard]] ImageView panned(const ImageView& view, const glm::dvec2& by);
/// One screen pixel per image pixel; what is in the middle stays there.
[[nodiscard]] ImageView one_to_one(const ImageView& view);

} // namespace lightcuts::viz
