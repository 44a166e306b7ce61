// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <oracle/cases/case.h>
#include <oracle/properties/judge.h>

namespace lightcuts::fuzz {

/// The library.
[[nodiscard]] const oracle::Subject& library();

/// Where a property does not hold: shrinks the case, saves it as counterexample-PROPERTY.json in
/// the folder $LIGHTCUTS_FUZZ_FINDINGS, by default the current one, and is a finding().
void require_held(const oracle::Case& on, const oracle::Tally& tally);

/// Judges the library by what `check` asks a judge at each of the case's views, and of its tree.
void judge_views(
    const oracle::Case& on,
    const std::function<void(const oracle::Judge&, const oracle::PointAnswers&)>& check);

/// Judges the library on the case by one property, or by all.
void judge(const oracle::Case& on, std::optional<oracle::Property> only = std::nullopt);

} // namespace lightcuts::fuzz
