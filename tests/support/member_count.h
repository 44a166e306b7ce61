// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

namespace lightcuts {
namespace detail {

/// Stands for a value of any type.
struct Anything {
  template <class T>
  operator T() const; // NOLINT: implicit on purpose
};

template <class T, std::size_t... i>
[[nodiscard]] constexpr bool takes(std::index_sequence<i...> /*count*/) {
  return requires { T{(static_cast<void>(i), Anything{})...}; };
}

} // namespace detail

/// How many members a plain struct has: as many as its braces take.
template <class T, std::size_t least = 0>
[[nodiscard]] constexpr std::size_t member_count() {
  if constexpr (detail::takes<T>(std::make_index_sequence<least + 1>{}))
    return member_count<T, least + 1>();
  else
    return least;
}

} // namespace lightcuts
