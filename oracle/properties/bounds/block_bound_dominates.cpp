// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/block_answers.h>
#include <oracle/properties/bounds/bound_dominates_contribution.h>

namespace lightcuts::oracle {
namespace {

void check_block(const BlockAnswers& of, const Recorder& record) {
  for (std::uint32_t i = of.nodes.begin; i < of.nodes.end; ++i)
    check_dominates(of.point, i, of.bounds[i], "block's bound", record);
}

} // namespace

const PropertyInfo property::block_bound_dominates{
    .name = "block-bound-dominates",
    .statement = "A cluster's bound over a block of points is at least what its lights would "
                 "contribute to each of them.",
    .formula = "sum of contributions <= bound of the block, per channel, at each of its points",
    .needs = only(Part::block_bounds),
    .of_block = check_block,
};

} // namespace lightcuts::oracle
