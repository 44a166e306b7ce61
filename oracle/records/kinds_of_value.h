// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightcuts::oracle {

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_variant = false;
template <class... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_glm_vector = false;
template <glm::length_t n, class T, glm::qualifier q>
inline constexpr bool is_glm_vector<glm::vec<n, T, q>> = true;

/// The name of the type in the source, without namespaces: "Phong".
template <class T>
[[nodiscard]] std::string type_name() {
  const std::string_view function = __PRETTY_FUNCTION__; // "... [with T = lightcuts::Phong; ...]"
  const std::size_t begin = function.find("T = ") + 4;
  const std::string_view type = function.substr(begin, function.find_first_of(";]", begin) - begin);
  return std::string(type.substr(type.rfind(':') + 1));
}

} // namespace lightcuts::oracle
