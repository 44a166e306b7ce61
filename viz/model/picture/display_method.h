// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <lightcuts/render/view/renderer.h>

namespace lightcuts::viz {

/// How the picture is made: one of the library's methods, or rasterised without shadows.
class DisplayMethod {
public:
  constexpr DisplayMethod(Method method) : method_(method) {} // NOLINT: is one
  [[nodiscard]] static constexpr DisplayMethod raster() { return DisplayMethod(); }

  [[nodiscard]] constexpr bool is_raster() const { return !method_; }
  /// Of the raster preview: lightcuts, whose cut is shown beside it.
  [[nodiscard]] constexpr Method method() const { return method_.value_or(Method::lightcuts); }

  constexpr bool operator==(const DisplayMethod&) const = default;

private:
  constexpr DisplayMethod() = default;
  std::optional<Method> method_;
};

/// In the order of Tab.
inline constexpr DisplayMethod all_displays[] = {
    DisplayMethod::raster(), Method::reference,
    Method::lightcuts,       Method::no_specular_bound,
    Method::stochastic,      Method::stochastic_intensity,
    Method::paper,           Method::unscaled};

/// "raster", or the library's name of it.
[[nodiscard]] const char* name_of(const DisplayMethod& display);
[[nodiscard]] std::optional<DisplayMethod> display_named(std::string_view name);
/// One sentence.
[[nodiscard]] const char* meaning_of(const DisplayMethod& display);
/// The next one in the order of Tab, or with -1 the one before; it goes round.
[[nodiscard]] DisplayMethod next(const DisplayMethod& display, int direction);

} // namespace lightcuts::viz
