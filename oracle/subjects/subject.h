// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/blocks/proven_visibility.h>
#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/subjects/topology.h>

namespace lightcuts {
class SceneView;
struct VisiblePoint;
struct RenderConfig;
struct Rendering;
class LightTree;
} // namespace lightcuts

namespace lightcuts::oracle {

using Parts = unsigned;

/// Parts of an implementation that are judged separately, and what it claims of itself; one bit
/// each.
enum class Part : unsigned {
  bounds = 1,            ///< SubjectTree::bound()
  lower_bounds = 2,      ///< SubjectTree::lower_bound()
  estimates = 4,         ///< SubjectTree::estimate()
  cuts = 8,              ///< SubjectTree::select()
  sampling = 16,         ///< SubjectTree::sample() and probability()
  refinement_order = 32, ///< Subject::refined_before()
  occlusion = 64,        ///< Subject::sees()
  pictures = 128,        ///< Subject::render()
  random_cuts = 256,     ///< SubjectTree::draw()
  block_bounds = 512,    ///< SubjectTree::block_bounds()
  profiles = 1024,       ///< lights of LightKind::profile
  proofs = 2048,         ///< Subject::prove()
  // Claims.
  greedy_tree = 4096,  ///< the tree is that of greedy clustering
  library_rules = 8192 ///< what this library promises beyond what makes a light tree right
};
inline constexpr int part_count = 12; ///< claims not counted
inline constexpr Parts all_parts_and_claims = (1U << 14) - 1;
[[nodiscard]] constexpr Parts only(Part part) { return unsigned(part); }
[[nodiscard]] constexpr bool has(Parts parts, Part part) { return (parts & only(part)) != 0; }
[[nodiscard]] const char* name_of(Part part);
/// Names of the parts that are not in the set; claims have none.
[[nodiscard]] std::vector<std::string> names_without(Parts parts);

/// Whether a subject of these parts can be given these lights.
[[nodiscard]] bool takes(Parts parts, std::span<const Light> lights);

/// A light drawn from a cluster.
struct DrawnLight {
  std::uint32_t light = 0;
  double probability = 0; ///< with which it is drawn; 0: none was drawn, as none contributes
};

/// Thrown by a subject that cannot answer: it crashed, hung, or said what cannot be read.
class SubjectFailure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A light tree that a subject built, for one thread. `node`: an index in claim().nodes. Functions
/// outside the subject's parts throw std::logic_error; any may throw SubjectFailure.
class SubjectTree {
public:
  virtual ~SubjectTree() = default;
  /// Another user of this tree, for another thread.
  [[nodiscard]] virtual std::unique_ptr<SubjectTree> for_another_thread() const = 0;
  /// The tree as the subject describes it; see read_topology().
  [[nodiscard]] virtual TreeClaim claim() const = 0;

  /// The subject's upper bound of the cluster's unoccluded contribution: radiance, per channel.
  virtual glm::vec3 bound(std::uint32_t node, const ShadingPoint& point);
  /// bound() of every node; `out` has room for them.
  virtual void bounds(const ShadingPoint& point, std::span<glm::vec3> out);
  /// Of every node, an upper bound of the cluster's unoccluded contribution at each point of a
  /// block: radiance, per channel. The points are one or more, whose lobes differ in reflectance
  /// only; `out` has room for all nodes.
  virtual void block_bounds(std::span<const ShadingPoint> block, std::span<glm::vec3> out);
  /// The subject's lower bound of the cluster's unoccluded contribution: radiance, per channel.
  virtual glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point);
  /// The subject's estimate of the cluster's contribution if its representative is seen: radiance,
  /// given the cluster's bound().
  virtual glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                              const glm::vec3& bound);
  /// A cut for the point; valid until the next call. visible(i) tells whether light i is seen.
  virtual Cut select(const ShadingPoint& point, const CutConfig& config,
                     const std::function<bool(std::uint32_t)>& visible);
  /// Draws one of the cluster's lights by a random number u in [0, 1).
  virtual DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u);
  /// sample() by each of many random numbers; `out` has as many elements.
  virtual void samples(std::uint32_t node, const ShadingPoint& point, std::span<const double> u,
                       std::span<DrawnLight> out);
  /// The probability with which sample() draws the light.
  virtual double probability(std::uint32_t node, const ShadingPoint& point, std::uint32_t light);
  /// probability() of each of several lights.
  virtual std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                            std::span<const std::uint32_t> lights);
  /// A random estimate: each cluster of a cut lit by one light drawn by the subject's own random
  /// numbers, which `query` decides. The cut does not depend on `query`. Valid until the next call.
  virtual Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
                   const std::function<bool(std::uint32_t)>& visible);
  /// draw() for each of many queries, in their order; `take` must not ask the tree.
  virtual void draws(const ShadingPoint& point, const CutConfig& config,
                     std::span<const std::uint64_t> queries,
                     const std::function<bool(std::uint32_t)>& visible,
                     const std::function<void(const Cut&)>& take);
  /// The library's own tree underneath, or nothing for a foreign one.
  [[nodiscard]] virtual const LightTree* library_tree() const { return nullptr; }
};

/// What the oracle judges: the library, a broken variant of it, or a foreign implementation.
/// Functions may be called from many threads.
class Subject {
public:
  virtual ~Subject() = default;
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual Parts parts() const = 0;
  /// Whether it works in another process, whose processor time is not this one's.
  [[nodiscard]] virtual bool works_elsewhere() const { return false; }
  /// Builds a light tree; seed: of its random choices.
  [[nodiscard]] virtual std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                           std::uint64_t seed) const = 0;
  /// Gives the other tree up and builds one in its place, with whatever the subject keeps from one
  /// tree to the next: of a plug-in, in the same process, unless another thread is first.
  [[nodiscard]] virtual std::unique_ptr<SubjectTree>
  build_after(std::unique_ptr<SubjectTree> before, const LightSet& lights,
              std::uint64_t seed) const;
  /// Whether a cluster with the first relative bound is refined before one with the second.
  [[nodiscard]] virtual bool refined_before(double bound, double other) const;
  /// Whether a light is seen from the point.
  [[nodiscard]] virtual bool sees(const SceneView& view, const VisiblePoint& from,
                                  std::uint32_t light) const;
  /// What the subject proves of each cluster without casting a ray: whether all lights are seen
  /// from all of the points, or from none. Of what lies within a cluster of which it is known,
  /// nothing has to be said.
  [[nodiscard]] virtual std::vector<ProvenSight> prove(const SceneView& view, const LightTree& tree,
                                                       std::span<const VisiblePoint> points) const;
  /// A picture of the scene; a pixel is what select() makes of its point.
  [[nodiscard]] virtual Rendering render(const SceneView& view, const LightTree& tree,
                                         const RenderConfig& config) const;
};

} // namespace lightcuts::oracle
