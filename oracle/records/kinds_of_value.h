// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lightcuts::oracle {

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_variant = false;
template <class... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;

/// As the source has it, without namespaces: "Phong".
template <class T>
[[nodiscard]] std::string type_name() {
  const std::string_view function = __PRETTY_FUNCTION__; // "... [with T = lightcuts::Phong; ...]"
  const std::size_t begin = function.find("T = ") + 4;
  const std::string_view type = function.substr(begin, function.find_first_of(";]", begin) - begin);
  return std::string(type.substr(type.rfind(':') + 1));
}

} // namespace lightcuts::oracle
