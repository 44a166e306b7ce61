// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lightcuts::viz {

/// The indices below `count` in an order that is always the same but without any pattern: the
/// first k of them are a random subset.
[[nodiscard]] std::vector<std::uint32_t> random_order(std::size_t count);

} // namespace lightcuts::viz
