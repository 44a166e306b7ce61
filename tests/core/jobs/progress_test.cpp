// SPDX-License-Identifier: MIT
#include <lightcuts/core/jobs/progress.h>

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

using testing::ElementsAre;

TEST(Progress, GoesOnToTheEndWhereNobodyListens) {
  const Progress progress;
  progress.report(0.5);
  progress.part(0.5, 0.5).report(1);
  EXPECT_FALSE(progress.cancelled());
  EXPECT_NO_THROW(progress.leave_if_cancelled());
}

TEST(Progress, OfAPartIsThatOfTheWhole) {
  std::vector<double> told;
  bool cancelled = false;
  const Progress whole([&](double share) { told.push_back(share); }, [&] { return cancelled; });
  const Progress part = whole.part(0.5, 0.25);
  for (const double share : {0.0, 0.5, 1.0}) part.report(share);
  EXPECT_THAT(told, ElementsAre(0.5, 0.625, 0.75));
  EXPECT_FALSE(part.cancelled());
  cancelled = true;
  EXPECT_TRUE(part.cancelled());
}

TEST(Progress, LeavesOnceItIsCancelled) {
  int asked = 0;
  const Progress progress = Progress::until([&asked] { return ++asked == 2; });
  EXPECT_NO_THROW(progress.leave_if_cancelled());
  EXPECT_THROW(progress.leave_if_cancelled(), Cancelled);
  EXPECT_THROW(Progress::until([] { return true; }).part(0, 1).leave_if_cancelled(), Cancelled);
}

} // namespace
} // namespace lightcuts
