// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/text.h>

#include <gtest/gtest.h>

namespace lightcuts {
namespace {

TEST(Counted, IsPluralButOfOne) {
  EXPECT_EQ(counted(0, "light"), "0 lights");
  EXPECT_EQ(counted(1, "light"), "1 light");
  EXPECT_EQ(counted(1'000'000, "light"), "1000000 lights");
}

} // namespace
} // namespace lightcuts
