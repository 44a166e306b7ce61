// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <lightcuts/render/view/renderer.h>

namespace lightcuts::viz {

/// How the picture is made: one of the library's methods, or rasterised without shadows.
class DisplayMethod {
public:
  constexpr DisplayMethod(Method method) : method_(method) {}                   // NOLINT: is one
  constexpr DisplayMethod(const MethodDescription& method) : method_(method) {} // NOLINT
  [[nodiscard]] static constexpr DisplayMethod raster() { return DisplayMethod(); }

  [[nodiscard]] constexpr bool is_raster() const { return !method_; }
  /// Of the raster preview: lightcuts, whose cut is shown beside it.
  [[nodiscard]] constexpr Method method() const { return method_.value_or(methods::lightcuts); }

  constexpr bool operator==(const DisplayMethod&) const = default;

private:
  constexpr DisplayMethod() = default;
  std::optional<Method> method_;
};

/// In the order of Tab: the preview, the reference, and the other methods from better to worse.
inline constexpr auto all_displays = []<std::size_t... I>(std::index_sequence<I...>) {
  static_assert(all_methods[0] == Method(methods::reference));
  return std::array{DisplayMethod::raster(), DisplayMethod(methods::reference),
                    DisplayMethod(all_methods[sizeof...(I) - I])...};
}
(std::make_index_sequence<std::size(all_methods) - 1>());

[[nodiscard]] constexpr const auto& values_of(std::type_identity<DisplayMethod> /*type*/) {
  return all_displays;
}

/// "raster", or the library's name of it.
[[nodiscard]] const char* name_of(const DisplayMethod& display);
/// One sentence.
[[nodiscard]] const char* meaning_of(const DisplayMethod& display);
/// The next one in the order of Tab, or with -1 the one before; it goes round.
[[nodiscard]] DisplayMethod next(const DisplayMethod& display, int direction);

} // namespace lightcuts::viz
