// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <variant>

#include <oracle/truth/lobes/cook_torrance.h>
#include <oracle/truth/lobes/no_lobe.h>
#include <oracle/truth/lobes/phong.h>
#include <oracle/truth/lobes/ward.h>

namespace lightcuts::oracle::radiometry {

/// f, 1/sr.
template <class Real, class OneLobe>
Vector<Real> lobe(const OneLobe& lobe, const Way<Real>& way) {
  return LobeTruth<OneLobe>::value(lobe, way);
}

/// A random lobe of that index into Lobe.
template <std::size_t first = 0>
[[nodiscard]] Lobe random_lobe(gen::Dice& dice, std::size_t index) {
  if constexpr (first + 1 < std::variant_size_v<Lobe>)
    if (index != first) return random_lobe<first + 1>(dice, index);
  return LobeTruth<std::variant_alternative_t<first, Lobe>>::random(dice);
}

} // namespace lightcuts::oracle::radiometry
