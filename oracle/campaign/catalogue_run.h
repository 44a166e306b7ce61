// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <oracle/cases/catalogue/catalogue.h>
#include <oracle/properties/judge.h>

namespace lightcuts::oracle {

/// What came of a named case.
struct NamedResult {
  const NamedCase* of = nullptr;
  Tally tally;
  std::uint64_t checks = 0;
  double worst_ratio = 0; ///< of all properties that have one
  /// The largest relative error, in any channel, of a light's own estimate, or of an exact cut:
  /// of what is above the least normal float. Nothing where the subject has neither.
  std::optional<double> max_relative_error;
  std::uint64_t saturated = 0;   ///< channels of bounds and radiances that are +inf
  std::size_t most_clusters = 0; ///< of a cut as the case configures it
  std::size_t lights = 0;
  double seconds = 0;
};

/// Judges the subject on the case by every property, and measures.
[[nodiscard]] NamedResult judge_named(const Subject& subject, const NamedCase& named,
                                      std::uint64_t place);

} // namespace lightcuts::oracle
