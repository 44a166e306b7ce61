// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <oracle/campaign/hunt.h>
#include <oracle/properties/bounds/block_answers.h>

namespace lightcuts::oracle {

/// Where in a counterexample its property does not hold.
struct FailingPlace {
  std::size_t view = 0;              ///< index of the shading point
  std::optional<std::uint32_t> node; ///< the first cluster, by index, that breaks a property of
                                     ///< bounds; nothing for one of cuts
  CutConfig cut;                     ///< of the first of cuts_of() that breaks one of cuts; else
                                     ///< the case's own
};

/// The first one; nothing where the property holds, or is not one of bounds or of a single cut.
/// Throws SubjectFailure where the subject cannot answer.
[[nodiscard]] std::optional<FailingPlace> failing_place(const Subject& subject,
                                                        const Counterexample& counterexample);

/// The first cluster, by index, on which the property does not hold at the point.
[[nodiscard]] std::optional<std::uint32_t> failing_cluster(const PointAnswers& of,
                                                           Property property);
/// The first cluster, by index, on which the property of a block does not hold at the point.
[[nodiscard]] std::optional<std::uint32_t> failing_cluster(const BlockAnswers& of,
                                                           Property property);

} // namespace lightcuts::oracle
