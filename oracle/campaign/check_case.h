// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <oracle/cases/case.h>
#include <oracle/properties/properties.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// Judges the subject on the case: everything but what takes many draws. `place` orders
/// violations. What the subject cannot answer counts as subject-answers. Throws InputError where
/// the case is not valid.
void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally);

/// The same for one property: its count is as check_case() has it, but what takes time and cannot
/// change it is left out.
void check_case_for(Property property, const Subject& subject, const Case& on, Tally& tally);

/// The cuts that are checked at every view: as the case has it, exact, and too small to converge.
[[nodiscard]] std::array<CutConfig, 3> cuts_of(const Case& on);

} // namespace lightcuts::oracle
