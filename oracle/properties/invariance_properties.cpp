// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/kernels/cluster_bound.h>
#include <oracle/properties/case_properties.h>

namespace lightcuts::oracle {
namespace {

/// What does not depend on how lights are clustered.
struct Answer {
  glm::vec3 root_bound{0}, radiance{0}; ///< radiance at threshold 0, all lights seen
};

/// Lights and one view of them.
struct Setting {
  std::vector<Light> lights;
  float min_distance;
  gen::View view;
};

Answer answer(const Subject& subject, const Setting& setting, std::uint64_t seed) {
  const gen::Scene scene{setting.lights, setting.view, setting.min_distance};
  const LightSet lights = scene.light_set();
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, seed);
  const ShadingPoint point = setting.view.point();
  Answer a;
  if (has(subject.parts(), Part::bounds)) a.root_bound = tree->bound(0, point);
  if (has(subject.parts(), Part::cuts))
    a.radiance = tree->select(point, {0, std::uint32_t(lights.size()), 0},
                              [](std::uint32_t) { return true; })
                     .radiance;
  return a;
}

// ---- changes; each says whether floats can express it exactly

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

bool brighten(Setting& s, float factor) {
  return std::all_of(s.lights.begin(), s.lights.end(),
                     [&](Light& light) { return scale(light.intensity, factor); });
}

/// By 4, so that square roots of lengths scale exactly, too; intensities with it, so that what
/// arrives stays the same.
bool enlarge(Setting& s) {
  bool exact = scale(s.min_distance, 4) && scale(s.view.position, 4);
  for (Light& light : s.lights)
    if (!is_at_infinity(light.kind))
      exact = exact && scale(light.position, 4) && scale(light.intensity, 16);
  return exact;
}

bool turn(Setting& s) {
  const auto turned = [](glm::vec3& v) { v = {v.y, v.z, v.x}; };
  turned(s.view.position);
  turned(s.view.normal);
  turned(s.view.to_viewer);
  for (Light& light : s.lights) {
    turned(light.position);
    turned(light.axis);
  }
  return true;
}

bool shift(Setting& s) {
  constexpr glm::vec3 by(1, -2, 4);
  const auto shifted = [&](glm::vec3& v) {
    const glm::vec3 moved = v + by;
    const bool exact = glm::dvec3(moved) == glm::dvec3(v) + glm::dvec3(by) && moved - by == v;
    v = moved;
    return exact;
  };
  bool exact = shifted(s.view.position);
  for (Light& light : s.lights)
    if (!is_at_infinity(light.kind)) exact = shifted(light.position) && exact;
  return exact;
}

bool reverse(Setting& s) {
  std::reverse(s.lights.begin(), s.lights.end());
  return s.lights.size() > 1;
}

bool split(Setting& s) {
  Light quarter = s.lights.front();
  for (int c = 0; c < 3; ++c)
    if (quarter.intensity[c] != 0 && quarter.intensity[c] < 0x1p-100F) return false;
  quarter.intensity *= 0.25F;
  s.lights.front() = quarter;
  s.lights.insert(s.lights.end(), 3, quarter);
  return true;
}

bool add_black(Setting& s) {
  s.lights.push_back(s.lights[s.lights.size() / 2]);
  s.lights.back().intensity = glm::vec3(0);
  return true;
}

// ---- comparison

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
};

class Invariance {
public:
  Invariance(const Subject& subject, const Setting& setting, std::uint64_t seed,
             std::uint64_t place, Tally& tally)
      : subject_(subject), setting_(setting), seed_(seed), place_(place), tally_(tally),
        before_(answer(subject, setting, seed)) {
    for (const Light& light : setting.lights) {
      clusters_matter_ = clusters_matter_ || has_axis(light.kind);
      mixed_ = mixed_ || light.kind != setting.lights.front().kind;
    }
  }

  /// To the last bit, once results are divided by `factor`.
  template <class Change>
  void exactly(Property property, float factor, Change&& change) {
    Setting changed = setting_;
    if (!change(changed)) return;
    const Answer after = answer(subject_, changed, seed_);
    Comparison comparison;
    for (int c = 0; c < 3; ++c) {
      // The bound of a mixed cluster is a sum of floats, of which one may be subnormal.
      if (!mixed_)
        comparison.add("root's bound", before_.root_bound[c], after.root_bound[c] / factor, 0);
      comparison.add("radiance", before_.radiance[c], after.radiance[c] / factor, 0);
    }
    record(property, comparison);
  }

  /// But for rounding: that of two bounds, and of two sums. Bounds of lights with axes depend on
  /// the order in which cones are merged.
  template <class Change>
  void closely(Property property, Change&& change) {
    Setting changed = setting_;
    if (!change(changed)) return;
    const Answer after = answer(subject_, changed, seed_);
    Comparison comparison;
    for (int c = 0; c < 3; ++c) {
      if (!clusters_matter_)
        comparison.add("root's bound", before_.root_bound[c], after.root_bound[c],
                       before_.root_bound[c] * 2 * bound_excess);
      comparison.add("radiance", before_.radiance[c], after.radiance[c],
                     2 * double(certified_error(before_.radiance[c], 0)));
    }
    record(property, comparison);
  }

private:
  void record(Property property, const Comparison& comparison) {
    tally_.record(property, comparison.holds, place_, comparison.worst,
                  [&] { return comparison.text; });
  }

  const Subject& subject_;
  const Setting& setting_;
  std::uint64_t seed_, place_;
  Tally& tally_;
  Answer before_;
  bool clusters_matter_ = false, mixed_ = false;
};

} // namespace

void check_invariance(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally) {
  if (on.views.empty() || on.lights.empty()) return;
  const Setting setting{on.lights, on.min_distance, on.views.front().view};
  Invariance exact(subject, setting, on.seed, place, tally);
  exact.exactly(Property::intensity_scales_exactly, 128,
                [](Setting& s) { return brighten(s, 128); });
  exact.exactly(Property::length_scales_exactly, 1, enlarge);

  // A mirror direction rounds, which sharp lobes magnify: the diffuse part only.
  Setting diffuse = setting;
  diffuse.view.material.lobe = NoLobe{};
  Invariance close(subject, diffuse, on.seed, place, tally);
  close.closely(Property::rotation_is_immaterial, turn);
  close.closely(Property::translation_is_immaterial, shift);
  close.closely(Property::light_order_is_immaterial, reverse);
  close.closely(Property::split_light_is_immaterial, split);
  close.closely(Property::black_light_is_immaterial, add_black);
}

} // namespace lightcuts::oracle
