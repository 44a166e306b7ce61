// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <lightcuts/core/lights/profile.h>

namespace lightcuts {

/// The profile that is alike in all half-planes and has of each vertical angle the largest share.
[[nodiscard]] Profile envelope_of(const Profile& profile);

/// A profile that is alike in all half-planes and nowhere below either of two such. Where both have
/// at most max_envelope_rows vertical angles together the larger of them at each of those, else at
/// fewer that have what is around them. One of them where it is as large.
[[nodiscard]] Profile united(const Profile& a, const Profile& b);

inline constexpr std::size_t max_envelope_rows = 64;

} // namespace lightcuts
