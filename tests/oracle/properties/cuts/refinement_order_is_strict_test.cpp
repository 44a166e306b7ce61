// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {
namespace {

using testing::HasSubstr;

class Ordering : public KernelSubject {
public:
  using Before = bool (*)(double, double);
  explicit Ordering(Before before) : KernelSubject("ordering"), before_(before) {}
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    return before_(bound, other);
  }

private:
  Before before_;
};

std::string fault_of_order(const Subject& subject) {
  Tally tally;
  Judge(library_parts, 0, tally).subject(subject);
  EXPECT_EQ(tally[Property::refinement_order_is_strict].cases, 1U);
  return tally[Property::refinement_order_is_strict].first_violation;
}

TEST(RefinementOrderIsStrict, HoldsForTheLibraryAndForAnyStrictOrder) {
  EXPECT_EQ(fault_of_order(*library_subject()), "");
  EXPECT_EQ(fault_of_order(*paper_subject()), "");
  EXPECT_EQ(fault_of_order(Ordering([](double a, double b) { return a < b; })), "");
  EXPECT_EQ(fault_of_order(Ordering([](double, double) { return false; })), "");
}

TEST(RefinementOrderIsStrict, ConvictsTheOrderThatHasEquals) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return a >= b; })),
              HasSubstr("each is refined before the other"));
}

// inf - inf is not a number.
TEST(RefinementOrderIsStrict, ConvictsADifferenceThatInfinitySpoils) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return !(a - b <= 0); })),
              HasSubstr("bounds inf and inf: each is refined before the other"));
}

TEST(RefinementOrderIsStrict, ConvictsWhatGoesRoundInCircles) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) {
                const auto kind = [](double v) { return v == 0 ? 0 : v < 1 ? 1 : 2; };
                return (kind(a) + 1) % 3 == kind(b);
              })),
              HasSubstr("not before, but something lies between"));
}

TEST(RefinementOrderIsStrict, ConvictsTiesWithinATolerance) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return a > b + 1; })),
              HasSubstr("differ, but both tie with a third"));
}

} // namespace
} // namespace lightcuts::oracle
