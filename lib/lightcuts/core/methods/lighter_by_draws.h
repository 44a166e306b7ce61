// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include <lightcuts/core/cut/stochastic_cut.h>
#include <lightcuts/core/methods/method.h>

namespace lightcuts {

[[nodiscard]] PixelResult result_of(const Cut& cut);

/// Lights each cluster of a cut by one light drawn by Importance.
template <class Importance>
class LighterByDraws final : public PointLighter {
public:
  explicit LighterByDraws(const LighterConfig& config)
      : select_(config.tree, config.cut, config.seed) {}

  static std::unique_ptr<PointLighter> make(const LighterConfig& config) {
    return std::make_unique<LighterByDraws>(config);
  }

  PixelResult light(const ShadingPoint& point, std::uint64_t query, Visibility visible) override {
    return result_of(select_(point, query, visible));
  }

private:
  BasicStochasticCutSelector<Importance> select_;
};

} // namespace lightcuts
