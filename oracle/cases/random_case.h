// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <oracle/cases/case.h>
#include <oracle/numbers/dice.h>

namespace lightcuts::oracle {

/// The index-th random case of a seed: as gen::make_scene() has it, with one to three views; one in
/// eight a picture_case(); one in 500 to be judged by many draws; one in 100 of many lights,
/// 2^k + 1 and 10^k in ascending order, then 2^k - 1 and 2^k, up to 2^14 and then to 2^17; one in
/// twelve with a history, which is very long in one of 4000. Same arguments, same bits.
[[nodiscard]] Case random_case(std::uint64_t seed, std::uint64_t index);

/// A case of few lights and one to three views, or of a block of neighbouring points, as most of
/// random_case() are: nothing that takes a second.
[[nodiscard]] Case small_case(gen::Dice& dice);

/// Of a case of so many lights, one at least.
[[nodiscard]] CutConfig random_cut(gen::Dice& dice, int lights);

/// How many lights random_case() will have there, if these are many; else 0.
[[nodiscard]] std::uint32_t many_lights_at(std::uint64_t index);

} // namespace lightcuts::oracle
