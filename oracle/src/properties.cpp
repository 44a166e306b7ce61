// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/properties.h>

#include <algorithm>

namespace lightcuts::oracle {
namespace {

constexpr std::array<PropertyInfo, property_count> infos{{
    {"bound-dominates-contribution",
     "A cluster's bound is at least what its lights would contribute if all were seen.",
     "sum of contributions <= bound, per channel"},
    {"bound-dominates-error",
     "A cluster's bound is at least the error of its estimate, whatever is occluded.",
     "|estimate - sum of seen contributions| <= bound, per channel"},
    {"bounds-are-ordered",
     "A cluster contributes between its lower and its upper bound, if nothing is occluded.",
     "lower bound <= sum of contributions, per channel; lower bound <= bound"},
    {"bound-shrinks-on-refinement",
     "The bounds of two children sum to no more than their parent's.",
     "bound(left) + bound(right) <= bound(parent) (1 + 2^-22), the rounding of bounds"},
    {"cut-partitions-lights", "Every light is in exactly one cluster of the cut.",
     "each path from the root to a leaf meets the cut once"},
    {"cut-obeys-threshold",
     "Unless the largest size was reached, every cluster's bound is within the threshold.",
     "bound <= max(threshold * total, black level), per channel; cut size <= largest size"},
    {"certified-error-holds", "The estimate differs from the truth by no more than it certifies.",
     "|radiance - exact| <= certified error, per channel"},
    {"zero-threshold-is-exact", "With threshold 0 the estimate is exact but for rounding.",
     "|radiance - exact| <= 2^-23 exact + 2^-149, per channel"},
    {"total-does-not-drift", "The radiance is the sum of the estimates over the cut.",
     "|radiance - sum of estimates| <= rounding of that sum, per channel"},
    {"tree-conserves-intensity", "A cluster's intensity is the total of its lights'.",
     "|intensity - sum| <= height * 2^-53 * sum, per channel"},
    {"representative-belongs",
     "A cluster's representative is one of its lights, and that of one of its children.",
     "by induction from the leaves, each of which is another light"},
    {"results-are-finite",
     "Nothing is NaN or negative; a bound is infinite only where the supremum is.",
     "bounds, radiance, certified error"},
    {"brdf-is-reciprocal", "A surface reflects as much from l to v as from v to l.",
     "|f(l,v) - f(v,l)| n.l n.v <= rounding of both, per channel"},
    {"brdf-conserves-energy",
     "Each part of a material reflects no more light than there is, its reflectance being 1.",
     "integral of f n.l over the hemisphere <= 1 + error of the quadrature; Ward's, near the "
     "horizon: <= max(1, min(0.068, 0.37 alpha^1.5) / sqrt(n.v)) + error"},
    {"occlusion-equals-brute-force",
     "A light is seen if and only if no triangle at all lies between.",
     "the answer of the tree of triangles = that of testing each, where rounding cannot decide it"},
}};

} // namespace

const PropertyInfo& info(Property property) { return infos[std::size_t(property)]; }

void Tally::merge(const Tally& other) {
  for (std::size_t i = 0; i < property_count; ++i) {
    PropertyCount& mine = counts_[i];
    const PropertyCount& theirs = other.counts_[i];
    mine.cases += theirs.cases;
    mine.violations += theirs.violations;
    mine.worst_ratio = std::max(mine.worst_ratio, theirs.worst_ratio);
    if (theirs.first_place < mine.first_place) {
      mine.first_place = theirs.first_place;
      mine.first_violation = theirs.first_violation;
    }
  }
}

std::uint64_t Tally::violations() const {
  std::uint64_t sum = 0;
  for (const PropertyCount& c : counts_) sum += c.violations;
  return sum;
}

double ratio_of(long double left, long double right) {
  if (left == 0 && right >= 0) return 0;
  constexpr double largest = std::numeric_limits<double>::max();
  const long double ratio = left / right;
  if (!(ratio >= 0) || ratio > largest) return largest;
  return static_cast<double>(ratio);
}

} // namespace lightcuts::oracle
