// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <vector>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

/// Keeps bounds for as long as the point is the same, by a number that each point stamps them with.
template <class Stamp>
struct StampedBounds : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    if (stamps.empty()) {
      stamps.resize(tree.nodes().size(), 0);
      bounds.resize(tree.nodes().size());
    }
    if (stamps[node] != now) {
      stamps[node] = now;
      bounds[node] = LibraryKernel::bound(tree, node, point);
    }
    return bounds[node];
  }
  mutable Stamp now = 0;
  mutable std::vector<Stamp> stamps;
  mutable std::vector<glm::vec3> bounds;
};

/// Bounds of a point that has been seen before at the same position.
struct BoundsByPosition : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    if (known.empty() || position != point.position()) {
      known.assign(tree.nodes().size(), glm::vec3(-1));
      position = point.position();
    }
    if (known[node].x < 0) known[node] = LibraryKernel::bound(tree, node, point);
    return known[node];
  }
  mutable glm::vec3 position{0};
  mutable std::vector<glm::vec3> known;
};

/// Selects by bounds that are kept; asked for one, it computes it.
template <class Kernel>
class KeepingTree : public LibraryTree {
public:
  explicit KeepingTree(std::shared_ptr<const LightTree> tree)
      : KeepingTree(std::move(tree), std::make_shared<Kernel>()) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<KeepingTree>(shared_tree());
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return contribution_bound(tree(), node, point);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    if constexpr (requires { kept_->now; }) ++kept_->now;
    return LibraryTree::select(point, config, visible);
  }

private:
  KeepingTree(std::shared_ptr<const LightTree> tree, std::shared_ptr<Kernel> kept)
      : LibraryTree(std::move(tree), kept), kept_(std::move(kept)) {}

  std::shared_ptr<Kernel> kept_;
};

/// Builds anew only where there are more lights than before, or fewer.
class KeepsTheTree : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build_after(std::unique_ptr<SubjectTree> before,
                                                         const LightSet& lights,
                                                         std::uint64_t seed) const override {
    const LightTree* old = before ? before->library_tree() : nullptr;
    if (old == nullptr || old->lights().size() != lights.size()) return build(lights, seed);
    return std::make_unique<LibraryTree>(LightTree(*old));
  }
};

std::unique_ptr<Subject> keeps_the_tree(const char* name) {
  return std::make_unique<KeepsTheTree>(name);
}

constexpr Mutant age_catalogue[] = {
    {"stamp-of-8-bits", "takes bounds of the 256th point before for those of the point",
     with_tree<KeepingTree<StampedBounds<std::uint8_t>>>},
    {"stamp-of-16-bits", "takes bounds of the 65536th point before for those of the point",
     with_tree<KeepingTree<StampedBounds<std::uint16_t>>>},
    {"cache-by-position", "reuses bounds of a point with another normal at the same position",
     with_tree<KeepingTree<BoundsByPosition>>},
    {"tree-of-lights-before", "keeps the tree when as many other lights come", keeps_the_tree},
};

} // namespace

std::span<const Mutant> age_mutants() { return age_catalogue; }

} // namespace lightcuts::oracle
