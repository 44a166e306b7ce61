// SPDX-License-Identifier: MIT
// Bytes become lights, points and thresholds; the tree and its cuts are compared with the naive
// tree and the sum over all lights.
#include <fuzz/support/judged_case.h>
#include <fuzz/support/target.h>
#include <oracle/cases/random_case.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::fuzz {
namespace {

void run_cuts(Bytes input) {
  gen::Dice dice(input);
  const oracle::Case on = oracle::small_case(dice);
  judge_views(on, [&](const oracle::Judge& judge, const auto& answers) {
    judge.cuts(answers, oracle::cuts_of(on.cut, on.lights.size()));
    judge.point(answers, on.cut);
  });
}

const Registered cuts({"cuts", run_cuts});

} // namespace
} // namespace lightcuts::fuzz
