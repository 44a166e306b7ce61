// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {

/// An 8-bit sRGB colour.
using Rgb8 = glm::vec<3, std::uint8_t>;

inline constexpr Rgb8 nan_colour{255, 0, 255};                 ///< magenta
inline constexpr Rgb8 infinity_colour{0, 255, 255};            ///< cyan: +infinity
inline constexpr Rgb8 negative_infinity_colour{255, 255, 255}; ///< white

/// The sRGB encoding of a linear colour, clamped to [0, 1]; NaN counts as 0.
[[nodiscard]] Rgb8 srgb8(const glm::vec3& linear);

/// Perceptually even colour maps, but for turbo, which tells more values apart.
enum class ColourMap : std::uint8_t { inferno, viridis, magma, plasma, turbo };
inline constexpr ColourMap all_colour_maps[] = {
    ColourMap::inferno, ColourMap::viridis, ColourMap::magma, ColourMap::plasma, ColourMap::turbo};
[[nodiscard]] constexpr std::array<const char*, 5> names_of(ColourMap /*any*/) {
  return {"inferno", "viridis", "magma", "plasma", "turbo"};
}

/// Which value gets which colour.
struct HeatMapScale {
  float lo = 0;             ///< the darkest colour, for this value and those below
  float hi = 1;             ///< the brightest colour, for this value and those above
  bool logarithmic = false; ///< equal ratios, not equal differences, get equal steps; needs lo > 0

  bool operator==(const HeatMapScale&) const = default;
};

/// Where `value` lies on the scale: 0 at lo, 1 at hi, clamped. Where lo = hi: 0 up to lo, 1 above.
/// value not NaN.
[[nodiscard]] float fraction_of(float value, const HeatMapScale& scale);

/// The value at `fraction` in [0, 1] of the scale.
[[nodiscard]] float value_at(float fraction, const HeatMapScale& scale);

/// The colour of `value` on the map, and the colours above for NaN and infinities. Safe to call
/// from many threads.
[[nodiscard]] Rgb8 heat_colour(float value, const HeatMapScale& scale,
                               ColourMap map = ColourMap::inferno);

/// Writes `values` (size.x * size.y, row by row) as a PNG in heat_colour, with a colour bar and
/// its smallest, middle and largest value in a strip below. The numbers are left out where the
/// picture is too narrow or the font "DejaVuSans" is missing. Throws InputError, naming the file,
/// where it cannot be written or the scale is not finite with lo <= hi (0 < lo if logarithmic).
void write_heat_map(const std::filesystem::path& file, glm::uvec2 size,
                    std::span<const float> values, const HeatMapScale& scale);

/// Writes size.x * size.y pixels, row by row from the top left, as an 8-bit PNG. Throws InputError,
/// naming the file, where it cannot be written.
void write_png(const std::filesystem::path& file, glm::uvec2 size, std::span<const Rgb8> pixels);

} // namespace lightcuts
