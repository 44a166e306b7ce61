// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/splitmix.h>

#include <gtest/gtest.h>

namespace lightcuts {
namespace {

// The published generator's first outputs for seed 1234567.
TEST(SplitMix64, GivesThePublishedSequence) {
  const std::uint64_t published[] = {6457827717110365317U, 3203168211198807973U,
                                     9817491932198370423U, 4593380528125082431U,
                                     16408922859458223821U};
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : published) {
    EXPECT_EQ(splitmix64(state), expected);
    state += splitmix64_step;
  }
}

} // namespace
} // namespace lightcuts
