// SPDX-License-Identifier: MIT
#include <algorithm>

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

/// Neighbours together; a point alone is a block of one.
class ByBlocks final : public PointLighter {
public:
  explicit ByBlocks(const LighterConfig& config) : select_(config.tree, config.cut, config.seed) {}

  [[nodiscard]] bool shares() const override { return true; }

  PixelResult light(const ShadingPoint& point, std::uint64_t query, Visibility visible) override {
    const BlockPoint alone{point, glm::vec2(0)};
    PixelResult result;
    light_all({&alone, 1}, query,
              [&](std::uint32_t /*point*/, std::uint32_t light) { return visible(light); },
              {&result, 1});
    return result;
  }

  void light_all(std::span<const BlockPoint> points, std::uint64_t query,
                 const BlockVisibility& visible, std::span<PixelResult> results) override {
    const std::span<const BlockCut> cuts = select_(points, query, visible);
    std::transform(cuts.begin(), cuts.end(), results.begin(), [](const BlockCut& cut) {
      return PixelResult{cut.radiance, cut.certified_error, static_cast<float>(cut.size),
                         static_cast<float>(cut.shadow_rays), cut.end};
    });
  }

private:
  BlockCutSelector select_;
};

} // namespace

void PointLighter::light_all(std::span<const BlockPoint> points, std::uint64_t query,
                             const BlockVisibility& visible, std::span<PixelResult> results) {
  for (std::uint32_t i = 0; i < points.size(); ++i)
    results[i] =
        light(points[i].point, query + i, [&](std::uint32_t light) { return visible(i, light); });
}

PixelResult result_of(const Cut& cut) {
  return {cut.radiance, cut.certified_error, static_cast<float>(cut.clusters.size()),
          static_cast<float>(cut.shadow_rays), cut.end};
}

std::unique_ptr<PointLighter> lighter_by_sums(const LighterConfig& config) {
  return std::make_unique<BySums>(config);
}

std::unique_ptr<PointLighter> lighter_by_blocks(const LighterConfig& config) {
  return std::make_unique<ByBlocks>(config);
}

std::unique_ptr<PointLighter> lighter_by_cuts(const LighterConfig& config,
                                              const ClusterRules& rules) {
  return std::make_unique<ByCuts>(config, rules);
}

} // namespace lightcuts
