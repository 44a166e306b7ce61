// SPDX-License-Identifier: MIT
// Bytes become lights and points; of each cluster every light's probability is asked for, and
// lights are drawn by random numbers, those between two lights among them.
#include <fuzz/support/judged_case.h>
#include <fuzz/support/target.h>
#include <oracle/cases/random_case.h>

namespace lightcuts::fuzz {
namespace {

void run_samplers(Bytes input) {
  gen::Dice dice(input);
  judge_views(oracle::small_case(dice),
              [](const oracle::Judge& judge, const auto& answers) { judge.odds(answers); });
}

const Registered samplers({"samplers", run_samplers});

} // namespace
} // namespace lightcuts::fuzz
