// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/tree_case.h>
#include <oracle/truth/naive_tree.h>

namespace lightcuts::oracle {
namespace {

constexpr std::size_t most_naive_lights = 12; // the naive tree takes N^3

void check_naive(const TreeCase& of, const Recorder& record) {
  const LightKinds kinds = of.lights.kinds();
  if (of.topology == nullptr || of.lights.size() > most_naive_lights || (kinds & (kinds - 1)) != 0)
    return;
  const double cost = tree_cost(*of.topology, of.lights);
  const double naive = naive_tree_cost(of.lights);
  if (!std::isfinite(naive)) return;
  const double allowed = naive * (1 + 0x1p-40);
  record(cost <= allowed, ratio_of(cost, allowed),
         [&] { return fmt::format("cost {:.9g}, of the naive tree {:.9g}", cost, naive); });
}

} // namespace

const PropertyInfo property::tree_equals_naive{
    .name = "tree-equals-naive",
    .statement = "The tree costs no more than the one that greedy clustering defines; asked of "
                 "trees that are greedy.",
    .formula = "sum of intensity * squared size over clusters <= that of the naive tree (1 + "
               "2^-40)",
    .severity = Severity::waste,
    .needs = only(Part::greedy_tree),
    .of_tree = check_naive,
};

} // namespace lightcuts::oracle
