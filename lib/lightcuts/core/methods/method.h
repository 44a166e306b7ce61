// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/blocks/block_cut_selector.h>
#include <lightcuts/core/cut/cut.h>
#include <lightcuts/core/cut/visibility.h>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What a method makes of one shading point.
struct PixelResult {
  glm::vec3 radiance{0};
  glm::vec3 certified_error{0}; ///< |radiance - exact| is at most this
  float cut_size = 0;           ///< clusters, or lights where they are summed
  float shadow_rays = 0;
  CutEnd end = CutEnd::converged;
};

/// Lights shading points by one method, one after another or neighbours together; one per thread.
class PointLighter {
public:
  virtual ~PointLighter() = default;
  /// Whether neighbours are to be lit together, by light_all().
  [[nodiscard]] virtual bool shares() const { return false; }
  /// query: that of the first point. A result for each point.
  virtual void light_all(std::span<const BlockPoint> points, std::uint64_t query,
                         const BlockVisibility& visible, std::span<PixelResult> results);
  /// query: a number of its own for each point, such as the pixel's index. visible(i) tells whether
  /// light i is seen from there.
  virtual PixelResult light(const ShadingPoint& point, std::uint64_t query, Visibility visible) = 0;
};

/// What a method is to light with; lights and their tree must outlive the lighter.
struct LighterConfig {
  const LightSet& lights;
  const LightTree& tree; ///< may be empty for a method that does not cut
  CutConfig cut;
  ClusterRules rules;      ///< of the method lightcuts
  LightKinds kinds = 0;    ///< for which the kernel is compiled; all: copes with any
  bool may_occlude = true; ///< false: lights are summed without asking what is visible
  bool use_tree = true;    ///< false: lightcuts sums all lights
  std::uint64_t seed = 1;  ///< of the methods that draw lights
};

/// What is known by its address: a copy would be another one.
struct NotCopied {
  constexpr NotCopied() = default;
  NotCopied(const NotCopied&) = delete;
  NotCopied& operator=(const NotCopied&) = delete;
};

/// How pixels are lit. Each is described once, in a file of its own; see all_methods.h.
struct MethodDescription {
  const char* name;    ///< of the command line and reports
  const char* meaning; ///< one sentence
  bool draws;          ///< lights at random: LighterConfig::seed matters
  bool cuts;           ///< needs a tree
  ClusterRules rules;  ///< by which it picks cuts, if it does
  std::unique_ptr<PointLighter> (*lighter)(const LighterConfig& config);
  [[no_unique_address]] NotCopied not_copied{};
};

/// One of all_methods().
class Method {
public:
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr Method(const MethodDescription& description) : description_(&description) {}

  constexpr const MethodDescription* operator->() const { return description_; }
  bool operator==(const Method&) const = default;

private:
  const MethodDescription* description_;
};

/// Sums all lights.
[[nodiscard]] std::unique_ptr<PointLighter> lighter_by_sums(const LighterConfig& config);
/// Picks cuts for neighbours together.
[[nodiscard]] std::unique_ptr<PointLighter> lighter_by_blocks(const LighterConfig& config);
/// Picks a cut for each point by these rules.
[[nodiscard]] std::unique_ptr<PointLighter> lighter_by_cuts(const LighterConfig& config,
                                                            const ClusterRules& rules);

} // namespace lightcuts
