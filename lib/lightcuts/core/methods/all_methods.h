// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <lightcuts/core/methods/block_cuts.h>
#include <lightcuts/core/methods/lightcuts.h>
#include <lightcuts/core/methods/no_specular_bound.h>
#include <lightcuts/core/methods/paper.h>
#include <lightcuts/core/methods/reference.h>
#include <lightcuts/core/methods/stochastic.h>
#include <lightcuts/core/methods/stochastic_intensity.h>
#include <lightcuts/core/methods/unscaled.h>

namespace lightcuts {

/// The methods there are, roughly from worse to better but for the reference. A new one is a
/// description in a file of its own and an entry here.
inline constexpr Method all_methods[] = {methods::reference,  methods::unscaled,
                                         methods::paper,      methods::stochastic_intensity,
                                         methods::stochastic, methods::no_specular_bound,
                                         methods::lightcuts,  methods::block_cuts};

[[nodiscard]] constexpr std::optional<Method> method_named(std::string_view name) {
  for (const Method method : all_methods)
    if (name == method->name) return method;
  return std::nullopt;
}

} // namespace lightcuts
