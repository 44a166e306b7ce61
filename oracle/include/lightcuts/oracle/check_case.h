// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/oracle/case.h>
#include <lightcuts/oracle/properties.h>
#include <lightcuts/oracle/subject.h>

namespace lightcuts::oracle {

/// Judges the subject on the case: everything but what takes many draws. `place` orders
/// violations. What the subject cannot answer counts as subject-answers. Throws InputError where
/// the case is not valid.
void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally);

} // namespace lightcuts::oracle
