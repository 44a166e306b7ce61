// SPDX-License-Identifier: MIT
// Bytes become clusters and neighbouring points, which are bounded together.
#include <fuzz/support/judged_case.h>
#include <fuzz/support/target.h>
#include <oracle/cases/blocks.h>
#include <oracle/cases/random_case.h>

namespace lightcuts::fuzz {
namespace {

void run_blocks(Bytes input) {
  gen::Dice dice(input);
  oracle::Case on = oracle::small_case(dice);
  make_block(dice, on);
  judge(on, oracle::Property::block_bound_dominates);
}

const Registered blocks({"blocks", run_blocks});

} // namespace
} // namespace lightcuts::fuzz
