// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include <lightcuts/core/kinds/directional.h>
#include <lightcuts/core/kinds/luminaire.h>
#include <lightcuts/core/kinds/omni.h>
#include <lightcuts/core/kinds/oriented.h>
#include <lightcuts/core/kinds/spot.h>

namespace lightcuts {

/// The kinds of light there are, in the order of LightKind. A new one is a type in a file of its
/// own beside these, which CMake compiles a kernel for, and an entry here and in LightKind;
/// lighting/kinds and oracle/truth/kinds want their part, and the compiler asks for it:
///   kind                     its LightKind
///   emission(light, x)       the share of its intensity that a light sends towards x, in [0, 1],
///                            relative error emission_error; 0 from a light with an axis at x
///   max_emission, min_emission(e, q)  bounds of that over a cluster as seen along q, rounding
///                            included
///   mean_emission(e, representative, centroid, x)  its mean over the cluster, a guess
///   second_moment_factor     what the spread of the cluster's positions adds to an estimate
using LightKindList = std::tuple<Omni, Oriented, Spot, Directional, Luminaire>;
static_assert(std::tuple_size_v<LightKindList> == std::size_t(light_kind_count));

/// Calls f with an object of the kind's type.
template <class F, std::size_t I = 0>
decltype(auto) visit_kind(LightKind kind, F&& f) {
  using Kind = std::tuple_element_t<I, LightKindList>;
  static_assert(std::size_t(Kind::kind) == I);
  if constexpr (I + 1 < std::size_t(light_kind_count)) {
    if (kind != Kind::kind) return visit_kind<F, I + 1>(kind, std::forward<F>(f));
  }
  return f(Kind());
}

/// The share of its intensity that a light sends towards x; see LightKindList.
[[nodiscard]] inline double emission(const Light& light, const glm::vec3& x) {
  return visit_kind(light.kind, [&](auto kind) { return decltype(kind)::emission(light, x); });
}

} // namespace lightcuts
