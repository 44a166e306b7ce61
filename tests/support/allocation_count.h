// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace lightcuts {

/// Calls of operator new in this binary so far, of all threads.
std::size_t allocation_count();

} // namespace lightcuts
