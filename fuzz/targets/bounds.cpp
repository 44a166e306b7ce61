// SPDX-License-Identifier: MIT
// Bytes become clusters, points and materials; their bounds and estimates are judged by all
// properties of clusters.
#include <fuzz/support/judged_case.h>
#include <fuzz/support/target.h>
#include <oracle/cases/random_case.h>

namespace lightcuts::fuzz {
namespace {

void run_bounds(Bytes input) {
  gen::Dice dice(input);
  judge_views(oracle::small_case(dice),
              [](const oracle::Judge& judge, const auto& answers) { judge.clusters(answers); });
}

const Registered bounds({"bounds", run_bounds});

} // namespace
} // namespace lightcuts::fuzz
