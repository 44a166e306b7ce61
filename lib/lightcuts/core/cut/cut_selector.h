// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/cut/cut_loop.h>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

extern template class CutLoop<StoppingRule>;

/// Picks cuts by the library's stopping rule and, if not told otherwise, its default kernel for the
/// tree's kinds of light; see CutLoop. select(point, visible): a Cut.
class CutSelector : public CutLoop<StoppingRule> {
public:
  /// The tree must outlive the selector. Throws InputError, naming the field, where the
  /// configuration is NaN or out of its domain.
  explicit CutSelector(const LightTree& tree, const CutConfig& config = {},
                       const ClusterRules& rules = {})
      : CutLoop(tree, config, kernel_for(tree.lights().kinds(), rules)) {}
  /// By another kernel, which must outlive the selector, too.
  CutSelector(const LightTree& tree, const CutConfig& config, const ClusterKernel& kernel)
      : CutLoop(tree, config, kernel) {}
};

} // namespace lightcuts
