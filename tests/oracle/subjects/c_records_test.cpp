// SPDX-License-Identifier: MIT
#include <oracle/subjects/c_records.h>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <oracle/cases/case.h>

#include <tests/support/every_field.h>

namespace lightcuts::oracle {
namespace {

glm::vec3 vector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

Light from_c(const lightcuts_light& c) {
  return {LightKind(c.kind),
          vector(c.position),
          vector(c.intensity),
          vector(c.axis),
          c.cos_inner,
          c.cos_outer,
          {},
          {}};
}

Lobe lobe_from_c(const lightcuts_material& c) {
  switch (c.lobe) {
  case LIGHTCUTS_LOBE_PHONG:
    return Phong{vector(c.reflectance), c.width};
  case LIGHTCUTS_LOBE_WARD:
    return Ward{vector(c.reflectance), c.width};
  case LIGHTCUTS_LOBE_COOK_TORRANCE:
    return CookTorrance{vector(c.reflectance), c.width};
  default:
    return NoLobe{};
  }
}

gen::View from_c(const lightcuts_point& c) {
  return {vector(c.position),
          vector(c.normal),
          vector(c.to_viewer),
          {vector(c.material.diffuse), lobe_from_c(c.material)}};
}

CutConfig from_c(const lightcuts_cut_config& c) {
  return {c.threshold, c.max_size, c.black_level, c.unoccluded != 0};
}

TEST(CRecords, KeepEveryFieldOfLightsPointsAndCuts) {
  const auto on = unlike_default<Case>();
  EXPECT_EQ(leaves_of(from_c(as_c(on.cut))), leaves_of(on.cut));
  for (const Light& light : on.lights) {
    if (light.kind == LightKind::profile) continue; // see below
    EXPECT_EQ(leaves_of(from_c(as_c(light))), leaves_of(light));
    EXPECT_EQ(as_c(light).kind, unsigned(light.kind));
  }
  for (const CaseView& v : on.views)
    EXPECT_EQ(leaves_of(from_c(as_c(v.view.point()))), leaves_of(v.view));
}

TEST(CRecords, HaveNoLightsWithProfiles) {
  try {
    (void)as_c(Light{.kind = LightKind::profile});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault(), InputFault::unsupported);
  }
}

TEST(CRecords, HaveTheMirrorDirectionOfAPoint) {
  const ShadingPoint point(glm::vec3(0), {0, 0, 1}, {0, 0.6F, 0.8F}, {glm::vec3(1), {}});
  EXPECT_EQ(vector(as_c(point).mirror), point.mirror());
}

} // namespace
} // namespace lightcuts::oracle
