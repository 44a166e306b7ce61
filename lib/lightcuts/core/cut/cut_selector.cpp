// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/cut_selector.h>

namespace lightcuts {

template class CutLoop<StoppingRule>;

} // namespace lightcuts
