// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

namespace lightcuts {

/// Throws InputError as "area lights: count is 0, expected 1 to 100" unless least <= value <= most.
inline void require_within(const char* what, const char* field, std::uint64_t value,
                           std::uint64_t least, std::uint64_t most) {
  if (value < least || value > most)
    throw InputError(InputFault::out_of_domain, fmt::format("{}: {} is {}, expected {} to {}", what,
                                                            field, value, least, most));
}

} // namespace lightcuts
