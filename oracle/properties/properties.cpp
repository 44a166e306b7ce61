// SPDX-License-Identifier: MIT
#include <oracle/properties/properties.h>

#include <algorithm>

namespace lightcuts::oracle {
namespace {

constexpr std::array<PropertyInfo, property_count> infos{{
    {"tree-partitions-lights", "Every light is in exactly one leaf of one rooted tree.",
     "every index in range, every node but the root the child of one, every light of one leaf"},
    {"tree-conserves-intensity", "A cluster's intensity is the total of its lights'.",
     "|intensity - sum| <= height * 2^-53 * sum, per channel"},
    {"representative-belongs",
     "A cluster's representative is one of its lights, and that of one of its children.",
     "by induction from the leaves"},
    {"tree-equals-naive", "The tree costs no more than the one that greedy clustering defines.",
     "sum of intensity * squared size over clusters <= that of the naive tree (1 + 2^-40)",
     Severity::waste},
    {"bound-dominates-contribution",
     "A cluster's bound is at least what its lights would contribute if all were seen.",
     "sum of contributions <= bound, per channel"},
    {"bound-dominates-error",
     "A cluster's bound is at least the error of its estimate, whatever is occluded.",
     "|estimate - sum of seen contributions| <= bound, per channel"},
    {"bounds-are-ordered",
     "A cluster contributes between its lower and its upper bound, if nothing is occluded.",
     "lower bound <= sum of contributions, per channel; lower bound <= bound"},
    {"bound-shrinks-on-refinement", "The bounds of children sum to no more than their parent's.",
     "sum of the children's bounds <= bound (1 + 2^-22), the rounding of bounds"},
    {"bound-is-finite", "A bound is infinite only where the supremum is.",
     "bound < inf unless the point is in the box, or the largest float is exceeded",
     Severity::waste},
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
    {"tighter-threshold-refines", "The cut of a smaller threshold refines that of a larger one.",
     "each cluster of the one lies in a cluster of the other"},
    {"visibility-only-darkens", "Occluding lights does not add light.",
     "radiance at threshold 0 <= the same with all lights seen, but for rounding, per channel"},
    {"refinement-order-is-strict", "The order in which clusters are refined is a strict one.",
     "not a < a, not a < b < a; neither a < b nor b < a is transitive; also for infinite bounds"},
    {"results-are-finite", "Nothing is NaN or negative.",
     "bounds, estimates, radiance, certified error, probabilities, pixels"},
    {"threads-agree", "Asked again, and by another thread, it answers the same bits.",
     "bounds, estimates, radiance, certified error, draws"},
    {"probabilities-sum-to-one",
     "The lights of a cluster are drawn with probabilities that sum to 1, or less where none may "
     "be "
     "drawn.",
     "sum <= 1 + rounding; >= 1 - rounding where each light contributes"},
    {"contributing-lights-are-drawn",
     "A light that contributes is drawn with a probability above 0.",
     "probability > 0 wherever the contribution is"},
    {"draws-state-their-probability", "What is drawn comes with the probability of drawing it.",
     "probability of sample() = probability() of the same light"},
    {"draws-follow-probabilities", "Lights are drawn as often as their probabilities say.",
     "|count / n - probability| <= Bernstein's deviation, for each light"},
    {"draws-are-independent", "What is drawn of one cluster says nothing of another.",
     "|mean of (e - mean e) (e' - mean e')| <= Bernstein's deviation, for pairs of clusters"},
    {"stochastic-is-unbiased", "In the mean, draws give the exact sum.",
     "|mean of radiance - exact| <= Bernstein's deviation, per channel"},
    {"intensity-scales-exactly", "Lights 2^k times as bright: everything is, to the last bit.",
     "bounds, radiance at threshold 0 and certified error, divided by 2^k"},
    {"length-scales-exactly", "A scene 2^k times as large: nothing but 4^k changes.",
     "bounds and radiance at threshold 0, times 4^k, to the last bit"},
    {"rotation-is-immaterial", "A turn of the whole scene by right angles changes nothing.",
     "radiance at threshold 0 and the root's bound, but for rounding"},
    {"translation-is-immaterial", "A shift of the whole scene changes nothing.",
     "radiance at threshold 0 and the root's bound, but for rounding"},
    {"light-order-is-immaterial", "The order of the lights changes nothing.",
     "radiance at threshold 0 and the root's bound, but for rounding"},
    {"split-light-is-immaterial", "Four quarters of a light are that light.",
     "radiance at threshold 0 and the root's bound, but for rounding"},
    {"black-light-is-immaterial", "A light of intensity 0 changes nothing.",
     "radiance at threshold 0 and the root's bound, but for rounding"},
    {"brdf-is-reciprocal", "A surface reflects as much from l to v as from v to l.",
     "|f(l,v) - f(v,l)| n.l n.v <= rounding of both, per channel"},
    {"brdf-conserves-energy",
     "Each part of a material reflects no more light than there is, its reflectance being 1.",
     "integral of f n.l over the hemisphere <= 1 + error of the quadrature; Ward's, near the "
     "horizon: <= max(1, min(0.068, 0.37 alpha^1.5) / sqrt(n.v)) + error"},
    {"occlusion-equals-brute-force",
     "A light is seen if and only if no triangle at all lies between.",
     "the answer of the tree of triangles = that of testing each, where rounding can decide it"},
    {"pixels-equal-points", "A picture's pixel is what a cut for the point it sees gives.",
     "radiance of the pixel = radiance of the cut, to the last bit; 0 where it sees nothing"},
    {"subject-answers", "The subject does not crash, hang or answer what cannot be read.",
     "every call returns in time"},
}};

} // namespace

const PropertyInfo& info(Property property) { return infos[std::size_t(property)]; }

std::array<const char*, property_count> names_of(Property /*any*/) {
  std::array<const char*, property_count> names{};
  for (std::size_t i = 0; i < property_count; ++i) names[i] = info(Property(i)).name;
  return names;
}

std::optional<Property> property_named(std::string_view name) {
  for (std::size_t i = 0; i < property_count; ++i)
    if (name == infos[i].name) return Property(i);
  return std::nullopt;
}

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

std::uint64_t Tally::sum(Severity severity) const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < property_count; ++i)
    if (infos[i].severity == severity) sum += counts_[i].violations;
  return sum;
}

std::vector<Property> broken(const Tally& tally) {
  std::vector<Property> list;
  for (const Severity severity : {Severity::violation, Severity::waste})
    for (std::size_t i = 0; i < property_count; ++i)
      if (infos[i].severity == severity && tally[Property(i)].violations > 0)
        list.push_back(Property(i));
  return list;
}

double ratio_of(long double left, long double right) {
  if (left == 0 && right >= 0) return 0;
  constexpr double largest = std::numeric_limits<double>::max();
  const long double ratio = left / right;
  if (!(ratio >= 0) || ratio > largest) return largest;
  return static_cast<double>(ratio);
}

} // namespace lightcuts::oracle
