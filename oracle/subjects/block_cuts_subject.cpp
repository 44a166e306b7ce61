// SPDX-License-Identifier: MIT
#include <oracle/subjects/block_cuts_subject.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lightcuts/core/blocks/block_cut_selector.h>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/numerics/splitmix.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

/// Numbers in [0, 1) that a point decides.
class PointDice {
public:
  explicit PointDice(const ShadingPoint& point) {
    for (const glm::vec3& v : {point.position(), point.normal(), point.to_viewer()})
      for (int c = 0; c < 3; ++c) state_ = splitmix64(state_ ^ std::bit_cast<std::uint32_t>(v[c]));
  }
  double number() {
    state_ = splitmix64(state_);
    return double(state_ >> 11) * 0x1p-53;
  }
  glm::vec3 vector() {
    const double x = number(), y = number(), z = number();
    return 2.0F * glm::vec3(x, y, z) - 1.0F;
  }
  [[nodiscard]] std::uint64_t state() const { return state_; }

private:
  std::uint64_t state_ = 0;
};

glm::vec3 turned(const glm::vec3& unit, const glm::vec3& by) {
  return glm::vec3(glm::normalize(glm::dvec3(unit) + glm::dvec3(by)));
}

/// Brighter and darker versions of it.
Material like(const Material& material, double share) {
  Material other = material;
  other.diffuse *= float(share);
  std::visit(
      [&](auto& lobe) {
        if constexpr (requires { lobe.reflectance; }) lobe.reflectance *= float(share);
      },
      other.lobe);
  return other;
}

/// The point, somewhere among its neighbours.
struct Block {
  std::vector<BlockPoint> points;
  std::uint32_t own = 0;

  explicit Block(const ShadingPoint& point, PointDice& dice) {
    constexpr unsigned side = 4;
    own = std::uint32_t(dice.number() * (side * side));
    // From all but one point to as wide as it is far from the origin, or a metre.
    const float extent = float(std::exp2(-30 * dice.number())) *
                         std::max(1.0F, glm::length(point.position()) * 0x1p-4F);
    const float turn = dice.number() < 0.5 ? 0 : float(dice.number()) * 0.5F;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const std::uint32_t column = i % side, row = i / side;
      const glm::vec2 place{float(column), float(row)};
      if (i == own) {
        points.push_back({point, place});
        continue;
      }
      const glm::vec3 moved = point.position() + extent * dice.vector();
      const glm::vec3 position =
          glm::all(glm::lessThan(glm::abs(moved), glm::vec3(1e38F))) ? moved : point.position();
      points.push_back({ShadingPoint(position, turned(point.normal(), turn * dice.vector()),
                                     turned(point.to_viewer(), turn * dice.vector()),
                                     like(point.material(), dice.number())),
                        place});
    }
  }
};

class BlockCutsTree final : public LibraryTree {
public:
  BlockCutsTree(std::shared_ptr<const LightTree> tree, BlockSlip slip)
      : LibraryTree(std::move(tree)), slip_(slip) {}

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BlockCutsTree>(shared_tree(), slip_);
  }

  /// A block's bound of a lobe may be less than a point's own; both hold.
  void bounds(const ShadingPoint& point, std::span<glm::vec3> out) override {
    LibraryTree::bounds(point, out);
    const ShadingBlock alone({&point, 1});
    for (std::uint32_t i = 0; i < out.size(); ++i)
      out[i] = glm::min(out[i], contribution_bound(tree(), i, alone));
  }

  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    PointDice dice(point);
    const Block block(point, dice);
    const std::uint32_t another = (block.own + 1) % block.points.size();
    const auto seen = [&](std::uint32_t p, std::uint32_t light) {
      if (slip_ == BlockSlip::eyes_of_another && p == block.own) p = another;
      const std::uint64_t bits = splitmix64(dice.state() ^ (std::uint64_t(p) << 32 | light));
      const bool differs = p != block.own && bits % 8 == 0;
      return visible(light) != differs;
    };
    BlockCutSelector selector(tree(), config);
    const auto cuts = selector(block.points, 1, seen, &clusters_);
    if (slip_ == BlockSlip::cut_of_another)
      return lit(point, clusters_[another], cuts[another], visible);
    const BlockCut& found = cuts[block.own];
    return {.radiance = found.radiance,
            .certified_error = found.certified_error,
            .clusters = clusters_[block.own],
            .shadow_rays = found.shadow_rays,
            .end = found.end};
  }

private:
  /// The point by clusters of a cut that is not its own.
  [[nodiscard]] Cut lit(const ShadingPoint& point, std::vector<CutCluster>& clusters,
                        const BlockCut& of, const std::function<bool(std::uint32_t)>& visible) {
    glm::dvec3 total(0), error(0);
    for (CutCluster& c : clusters) {
      c.visible = visible(tree().node(c.node).representative);
      c.estimate = c.visible ? estimate(c.node, point, c.bound) : glm::dvec3(0);
      total += c.estimate;
      error += glm::dvec3(c.bound);
    }
    Cut cut{.clusters = clusters, .shadow_rays = of.shadow_rays, .end = of.end};
    for (int c = 0; c < 3; ++c) {
      cut.radiance[c] = to_float(total[c]);
      cut.certified_error[c] = certified_error(total[c], error[c]);
    }
    return cut;
  }

  BlockSlip slip_;
  std::vector<std::vector<CutCluster>> clusters_;
};

class BlockCutsSubject final : public KernelSubject {
public:
  BlockCutsSubject(std::string name, BlockSlip slip)
      : KernelSubject(std::move(name)), slip_(slip) {}
  [[nodiscard]] Parts parts() const override {
    return KernelSubject::parts() & ~only(Part::pictures) & ~only(Part::library_rules);
  }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<BlockCutsTree>(
        std::make_shared<const LightTree>(lightcuts::build(lights, {seed})), slip_);
  }

private:
  BlockSlip slip_;
};

} // namespace

std::unique_ptr<Subject> block_cuts_subject(std::string name, BlockSlip slip) {
  return std::make_unique<BlockCutsSubject>(std::move(name), slip);
}

} // namespace lightcuts::oracle
