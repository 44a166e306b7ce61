// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <oracle/cases/case.h>

namespace lightcuts::oracle {

/// The case without so many of its lights, from the first named on.
[[nodiscard]] Case without_lights(Case of, std::uint32_t first, std::uint32_t count);

/// Hands cases that are simpler to the visitor, the simplest first, until it returns true; none
/// for the simplest of all. Each is made when its turn has come. Returns whether the visitor did.
bool visit_simpler(const Case& of, const std::function<bool(Case&)>& visitor);

/// All of them: for cases of few lights.
[[nodiscard]] std::vector<Case> simpler(const Case& of);

} // namespace lightcuts::oracle
