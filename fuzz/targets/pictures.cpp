// SPDX-License-Identifier: MIT
// Bytes become a few triangles and lights: what is seen, and what is invariant, against brute
// force.
#include <fuzz/support/judged_case.h>
#include <fuzz/support/target.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/random_picture.h>

namespace lightcuts::fuzz {
namespace {

void run_pictures(Bytes input) {
  gen::Dice dice(input);
  judge(dice.one_in(2) ? oracle::picture_case(dice) : oracle::small_case(dice));
}

const Registered pictures({"pictures", run_pictures});

} // namespace
} // namespace lightcuts::fuzz
