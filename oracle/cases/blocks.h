// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/cases/case.h>

namespace lightcuts::oracle {

/// Whether the case's views can be bounded together, as one block: there is one, and their lobes
/// are of one kind and shape, whatever they reflect.
[[nodiscard]] bool is_block(const Case& of);

/// Puts up to four neighbours of the first view in place of the others: next to each other or as
/// far apart as the lights, bent a little or much, of other reflectance.
void make_block(gen::Dice& dice, Case& of);

} // namespace lightcuts::oracle
