// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include <glm/vec3.hpp>
#include <lightcuts/cut_selector.h>
#include <lightcuts/light_tree.h>

namespace lightcuts::oracle {

/// Picks cuts for one shading point after another; see BasicCutSelector.
class Selector {
public:
  virtual ~Selector() = default;
  /// Valid until the next call.
  virtual Cut select(const ShadingPoint& point,
                     const std::function<bool(std::uint32_t)>& visible) = 0;
};

/// What the oracle judges: the library, or a broken variant of it.
class Subject {
public:
  virtual ~Subject() = default;
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual const LightTree& tree() const = 0;
  /// What the subject takes for an upper bound of the cluster's contribution, per channel.
  [[nodiscard]] virtual glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) const = 0;
  /// What it takes the cluster to contribute if its representative is seen, given its bound.
  [[nodiscard]] virtual glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                                            const glm::vec3& bound) const = 0;
  /// A selector for one thread.
  [[nodiscard]] virtual std::unique_ptr<Selector> selector(const CutConfig& config) const = 0;
};

/// The subject's estimate of a cluster, occlusion included. visible: per light, whether it is seen;
/// a representative below the horizon counts as seen.
[[nodiscard]] inline glm::dvec3 seen_estimate(const Subject& subject, std::uint32_t node,
                                              const ShadingPoint& point, const glm::vec3& bound,
                                              std::span<const char> visible) {
  const LightTree& tree = subject.tree();
  const std::uint32_t index = tree.node(node).representative;
  const Light& light = tree.lights()[index];
  const bool seen =
      visible[index] != 0 ||
      dot_between(point.normal(), viewed_from(light.kind, point.position()), light.position) <= 0;
  return seen ? subject.estimate(node, point, bound) : glm::dvec3(0);
}

/// The library with the given rules: LightcutsRules, or a mutant's.
template <class Rules>
class RulesSubject : public Subject {
public:
  /// The tree must outlive the subject.
  RulesSubject(std::string name, const LightTree& tree) : name_(std::move(name)), tree_(&tree) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] const LightTree& tree() const override { return *tree_; }
  [[nodiscard]] glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) const override {
    return std::visit([&](const auto& lobe) { return Rules::bound(*tree_, node, point, lobe); },
                      point.material().lobe);
  }
  [[nodiscard]] glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return std::visit(
        [&](const auto& lobe) { return Rules::estimate(*tree_, node, point, lobe, bound); },
        point.material().lobe);
  }
  [[nodiscard]] std::unique_ptr<Selector> selector(const CutConfig& config) const override {
    return std::make_unique<RulesSelector>(*tree_, config);
  }

private:
  class RulesSelector : public Selector {
  public:
    RulesSelector(const LightTree& tree, const CutConfig& config) : select_(tree, config) {}
    Cut select(const ShadingPoint& point,
               const std::function<bool(std::uint32_t)>& visible) override {
      return select_(point, visible);
    }

  private:
    BasicCutSelector<Rules> select_;
  };

  std::string name_;
  const LightTree* tree_;
};

} // namespace lightcuts::oracle
