// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/campaign/hunt.h>

namespace lightcuts::oracle {

/// Judges the case again, and shows for the property how its two sides come about, step by step,
/// and where they part, in lines of at most 100 columns. What is shown of the truth comes from
/// 700-bit arithmetic. For a property of
/// - bounds: the first cluster, by index, on which it does not hold; its lights one by one (q,
///   |q|, n.l, falloff, emission, BRDF, contribution), the suprema over its box, the library's own
///   bound of these lights, the subject's bound, and the truth;
/// - cuts: the refinement cluster by cluster, with bounds, estimates and their share of the
///   threshold; total, certified error and truth;
/// - trees: the tree node by node, and what is wrong with it;
/// - anything else: what check_case() says, and the case.
/// Where the property holds, it says so.
[[nodiscard]] std::string explain(const Subject& subject, const Counterexample& counterexample);

} // namespace lightcuts::oracle
