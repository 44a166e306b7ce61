// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/shaft_prover.h>

namespace lightcuts {

template class BasicShaftProver<ShaftRules>;

} // namespace lightcuts
