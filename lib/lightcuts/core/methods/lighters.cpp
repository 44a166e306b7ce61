// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/methods/lighter_by_draws.h>
#include <lightcuts/core/methods/method.h>
#include <lightcuts/core/numerics/rounding.h>

namespace lightcuts {
namespace {

class BySums final : public PointLighter {
public:
  explicit BySums(const LighterConfig& config)
      : lights_(config.lights), may_occlude_(config.may_occlude) {}

  PixelResult light(const ShadingPoint& point, std::uint64_t /*query*/,
                    Visibility visible) override {
    const LightSum sum = sum_lights(
        lights_, point, [&](std::uint32_t light) { return !may_occlude_ || visible(light); });
    PixelResult result;
    for (int c = 0; c < 3; ++c) {
      result.radiance[c] = to_float(sum.radiance[c]);
      result.certified_error[c] = certified_error(sum.radiance[c], 0);
    }
    result.cut_size = static_cast<float>(lights_.size());
    result.shadow_rays = may_occlude_ ? static_cast<float>(sum.shadow_rays) : 0;
    return result;
  }

private:
  const LightSet& lights_;
  bool may_occlude_;
};

class ByCuts final : public PointLighter {
public:
  ByCuts(const LighterConfig& config, const ClusterRules& rules)
      : select_(config.tree, config.cut, kernel_for(config.kinds, rules)) {}

  PixelResult light(const ShadingPoint& point, std::uint64_t /*query*/,
                    Visibility visible) override {
    return result_of(select_(point, visible));
  }

private:
  CutSelector select_;
};

} // namespace

PixelResult result_of(const Cut& cut) {
  return {cut.radiance, cut.certified_error, static_cast<float>(cut.clusters.size()),
          static_cast<float>(cut.shadow_rays), cut.end};
}

std::unique_ptr<PointLighter> lighter_by_sums(const LighterConfig& config) {
  return std::make_unique<BySums>(config);
}

std::unique_ptr<PointLighter> lighter_by_cuts(const LighterConfig& config,
                                              const ClusterRules& rules) {
  return std::make_unique<ByCuts>(config, rules);
}

} // namespace lightcuts
