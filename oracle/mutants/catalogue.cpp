// SPDX-License-Identifier: MIT
#include <vector>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {

std::span<const Mutant> mutants() {
  static const std::vector<Mutant> all = [] {
    std::vector<Mutant> list;
    for (const auto group : {bound_mutants(), tree_mutants(), cut_mutants(), sampling_mutants(),
                             shading_mutants(), subtle_mutants(), size_mutants(), age_mutants(),
                             block_mutants(), profile_mutants(), shaft_mutants()})
      list.insert(list.end(), group.begin(), group.end());
    return list;
  }();
  return all;
}

const Mutant* mutant_named(std::string_view name) {
  for (const Mutant& mutant : mutants())
    if (name == mutant.name) return &mutant;
  return nullptr;
}

} // namespace lightcuts::oracle
