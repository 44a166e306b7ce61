// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/kernels/cluster_bound.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

/// Where results are so small or large that they round otherwise when scaled.
bool rounds_as_usual(float value) { return value == 0 || (value > 0x1p-100F && value < 0x1p100F); }

struct Comparison {
  bool holds = true;
  double worst = 0;
  std::string text;

  void add(const char* what, float before, float after, double allowed) {
    if (!rounds_as_usual(before) && !std::isnan(before)) return;
    const double difference = std::abs(double(after) - before);
    const double r = allowed == 0 ? (difference == 0 ? 0 : 2) : ratio_of(difference, allowed);
    worst = std::max(worst, r);
    if (r <= 1 || !holds) return;
    holds = false;
    text = fmt::format("{} {:.9g}, after the change {:.9g}", what, before, after);
  }
  void record(const Recorder& record) const {
    record(holds, worst, [&] { return text; });
  }
};

} // namespace

bool scale(float& value, float factor) {
  const float scaled = value * factor;
  const bool exact = std::isfinite(scaled) && scaled / factor == value &&
                     (value == 0 || std::abs(scaled) >= 0x1p-100F);
  value = scaled;
  return exact;
}

bool scale(glm::vec3& v, float factor) {
  const bool x = scale(v.x, factor), y = scale(v.y, factor), z = scale(v.z, factor);
  return x && y && z;
}

Invariance::Invariance(const Subject& subject, const Case& on)
    : subject_(subject),
      seed_(on.seed), setting_{on.lights, on.min_distance, on.views.front().view},
      diffuse_(setting_) {
  diffuse_.view.material.lobe = NoLobe{};
  for (const Light& light : on.lights) {
    with_axes_ = with_axes_ || has_axis(light.kind);
    mixed_ = mixed_ || light.kind != on.lights.front().kind;
  }
}

Invariance::Answer Invariance::answer(const Setting& setting) const {
  const LightSet lights =
      gen::Scene{setting.lights, setting.view, setting.min_distance}.light_set();
  const std::unique_ptr<SubjectTree> tree = subject_.build(lights, seed_);
  const ShadingPoint point = setting.view.point();
  Answer a;
  if (has(subject_.parts(), Part::bounds)) a.root_bound = tree->bound(0, point);
  if (has(subject_.parts(), Part::cuts))
    a.radiance =
        tree->select(point, exact_cut(lights.size()), [](std::uint32_t) { return true; }).radiance;
  return a;
}

void Invariance::exactly(Change change, float factor, const Recorder& record) const {
  if (!before_) before_ = answer(setting_);
  Setting changed = setting_;
  if (!change(changed)) return;
  const Answer after = answer(changed);
  Comparison comparison;
  for (int c = 0; c < 3; ++c) {
    // The bound of a mixed cluster is a sum of floats, of which one may be subnormal.
    if (!mixed_)
      comparison.add("root's bound", before_->root_bound[c], after.root_bound[c] / factor, 0);
    comparison.add("radiance", before_->radiance[c], after.radiance[c] / factor, 0);
  }
  comparison.record(record);
}

void Invariance::closely(Change change, const Recorder& record) const {
  if (!diffuse_before_) diffuse_before_ = answer(diffuse_);
  Setting changed = diffuse_;
  if (!change(changed)) return;
  const Answer after = answer(changed);
  Comparison comparison;
  for (int c = 0; c < 3; ++c) {
    const float bound = diffuse_before_->root_bound[c], radiance = diffuse_before_->radiance[c];
    // Bounds of lights with axes depend on the order in which cones are merged.
    if (!with_axes_)
      comparison.add("root's bound", bound, after.root_bound[c], bound * 2 * bound_excess);
    comparison.add("radiance", radiance, after.radiance[c],
                   2 * double(certified_error(radiance, 0)));
  }
  comparison.record(record);
}

} // namespace lightcuts::oracle
