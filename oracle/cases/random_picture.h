// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/cases/case.h>
#include <oracle/numbers/dice.h>

namespace lightcuts::oracle {

/// A few lights and a picture of a few triangles, in units of any size: a floor with things hanging
/// over it, or two in three what is hard for proofs of visibility: a small part of a floor, lights
/// far or close together, on surfaces, in closed boxes; needles, triangles edge-on, in planes
/// through the points or the lights, or twice at one place.
[[nodiscard]] Case picture_case(gen::Dice& dice);

} // namespace lightcuts::oracle
