// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <lightcuts/core/tree/cluster.h>

namespace lightcuts {

/// Sorts clusters along a Morton curve through their centres and axes, in cells whose sides are
/// powers of 1/2 of the whole, down to 2^-52 of it; equal cells by id.
void sort_by_morton_order(std::vector<Cluster>& clusters);

} // namespace lightcuts
