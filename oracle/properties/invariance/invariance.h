// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <oracle/cases/case.h>
#include <oracle/properties/properties.h>

namespace lightcuts::oracle {

/// Lights and one view of them.
struct Setting {
  std::vector<Light> lights;
  float min_distance;
  gen::View view;
};

/// Makes a setting another one; returns whether floats can express that exactly.
using Change = bool (*)(Setting&);

/// Multiplies, and says whether floats can express that exactly, with room for what follows.
bool scale(float& value, float factor);
bool scale(glm::vec3& v, float factor);

/// A case of which something is changed: compares what a subject answers before and after.
class Invariance {
public:
  /// The case has lights and a view.
  Invariance(const Subject& subject, const Case& on);

  /// To the last bit, once results are divided by `factor`.
  void exactly(Change change, float factor, const Recorder& record) const;
  /// But for rounding: that of two bounds, and of two sums. Of the diffuse part only: a mirror
  /// direction rounds, which sharp lobes magnify.
  void closely(Change change, const Recorder& record) const;

private:
  /// What a subject answers, whatever its clusters.
  struct Answer {
    glm::vec3 root_bound{0}, radiance{0}; ///< radiance at threshold 0, all lights seen
  };
  [[nodiscard]] Answer answer(const Setting& setting) const;

  const Subject& subject_;
  std::uint64_t seed_;
  Setting setting_, diffuse_;
  mutable std::optional<Answer> before_, diffuse_before_;
  bool with_axes_ = false, mixed_ = false;
};

} // namespace lightcuts::oracle
