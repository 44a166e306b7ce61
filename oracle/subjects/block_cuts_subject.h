// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// What goes wrong, on purpose, where neighbours share cuts.
enum class BlockSlip : std::uint8_t {
  none,
  cut_of_another, ///< a point's clusters are those of the cut of another one, by that one's total
  eyes_of_another ///< a point takes for seen what another one sees, light by light
};

/// The library's cuts that neighbours share: a point is judged as one of a block, its neighbours
/// being made up around it, with other reflectances, and each with some lights hidden that the
/// point sees, or the other way round.
[[nodiscard]] std::unique_ptr<Subject> block_cuts_subject(std::string name = "block-cuts",
                                                          BlockSlip slip = BlockSlip::none);

} // namespace lightcuts::oracle
