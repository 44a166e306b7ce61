// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <lightcuts/render/view/renderer.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {

/// The library with other rules; what a mutant derives from to put one thing of its own in place.
template <class Rules, class Importance = HierarchicalImportance<AnyFeatures>>
class RulesSubject : public Subject {
public:
  static constexpr Parts all_parts = (1U << unsigned(part_count)) - 1;

  explicit RulesSubject(std::string name, Rules rules = {})
      : name_(std::move(name)), rules_(std::move(rules)) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Parts parts() const override { return all_parts; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<RulesTree<Rules, Importance>>(lightcuts::build(lights, {seed}), rules_);
  }
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    return Rules::refined_before(bound, other);
  }
  [[nodiscard]] bool sees(const SceneView& view, const VisiblePoint& from,
                          std::uint32_t light) const override {
    return view.sees(from, light);
  }
  [[nodiscard]] Rendering render(const SceneView& view, const LightTree& tree,
                                 const RenderConfig& config) const override {
    return lightcuts::render(view, tree, config);
  }

private:
  std::string name_;
  Rules rules_;
};

} // namespace lightcuts::oracle
