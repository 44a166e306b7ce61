// SPDX-License-Identifier: MIT
#include <oracle/properties/tree_case.h>

namespace lightcuts::oracle {

const PropertyInfo property::tree_partitions_lights{
    .name = "tree-partitions-lights",
    .statement = "Every light is in exactly one leaf of one rooted tree.",
    .formula = "every index in range, every node but the root the child of one, every light of one "
               "leaf",
    .of_tree = [](const TreeCase& of,
                  const Recorder& record) { record(of.defect.empty(), [&] { return of.defect; }); },
};

} // namespace lightcuts::oracle
