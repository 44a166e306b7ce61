// SPDX-License-Identifier: MIT
#include <optional>

#include <gtest/gtest.h>
#include <oracle/campaign/hunt.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

// A cluster's bound is at least what its lights would contribute if all were seen.
TEST(IntensityOfRepresentative, BoundDominatesContribution) {
  Case on;
  on.lights = {
      {.kind = LightKind::omni,
       .position = {0x1.99999ap-4F, 0x0p+0F, 0x1p+0F},
       .intensity = {0x1p+0F, 0x1p+1F, 0x1.8p+1F}},
      {.kind = LightKind::oriented,
       .position = {0x0p+0F, 0x1p+0F, 0x1p+1F},
       .intensity = {0x1p+1F, 0x1p+1F, 0x1p+1F},
       .axis = {0x0p+0F, 0x0p+0F, -0x1p+0F}},
      {.kind = LightKind::spot,
       .position = {0x1p+0F, 0x1p+0F, 0x1p+1F},
       .intensity = {0x1p+2F, 0x1p+2F, 0x1p+2F},
       .axis = {0x0p+0F, 0x0p+0F, -0x1p+0F},
       .cos_inner = 0x1.cp-1F,
       .cos_outer = 0x1p-2F},
      {.kind = LightKind::directional,
       .position = {0x0p+0F, 0x0p+0F, 0x1p+0F},
       .intensity = {0x1p+0F, 0x1p+0F, 0x0p+0F}},
  };
  on.min_distance = 0x1p-4F;
  on.views = {
      {{.position = {0x0p+0F, 0x0p+0F, 0x0p+0F},
        .normal = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .to_viewer = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .material = {{0x1p-1F, 0x1p-1F, 0x1p-1F}, Phong{{0x1p-2F, 0x1p-2F, 0x1p-2F}, 0x1p+3F}}},
       {1, 2}},
      {{.position = {0x0p+0F, 0x1p+0F, 0x0p+0F},
        .normal = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .to_viewer = {0x0p+0F, 0x1.333334p-1F, 0x1.99999ap-1F},
        .material = {{0x1p-1F, 0x1p-1F, 0x1p-1F}, Ward{{0x1p-1F, 0x1p-1F, 0x1p-1F}, 0x1p-2F}}},
       {}},
      {{.position = {0x1p+0F, 0x0p+0F, 0x0p+0F},
        .normal = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .to_viewer = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .material = {{0x1.99999ap-4F, 0x1.99999ap-4F, 0x1.99999ap-4F},
                     CookTorrance{{0x1.47ae14p-5F, 0x1.47ae14p-5F, 0x1.47ae14p-5F}, 0x1p-1F}}},
       {0}},
      {{.position = {0x1p+0F, 0x1p+0F, 0x0p+0F},
        .normal = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .to_viewer = {0x0p+0F, 0x0p+0F, 0x1p+0F},
        .material = {{0x1p+0F, 0x1p+0F, 0x1p+0F}, NoLobe{}}},
       {}},
  };
  on.cut = {0x1.99999ap-4F, 7U, 0x1.0624dep-10F, false};
  on.seed = 12345678901234567890U;
  on.triangles = {
      {{{{-0x1p+2F, -0x1p+2F, 0x0p+0F}, {0x1p+2F, -0x1p+2F, 0x0p+0F}, {0x0p+0F, 0x1p+2F, 0x0p+0F}}},
       0},
      {{{{0x0p+0F, 0x0p+0F, 0x1p-1F}, {0x1p+0F, 0x0p+0F, 0x1p-1F}, {0x0p+0F, 0x1p+0F, 0x1p-1F}}},
       3},
  };
  on.camera = {{0x0p+0F, -0x1.8p+1F, 0x1.8p+1F},
               {0x0p+0F, 0x0p+0F, 0x0p+0F},
               {0x0p+0F, 0x0p+0F, 0x1p+0F},
               0x1.9p+5F};
  on.image_size = {3, 2};
  EXPECT_EQ(failure_of(*library_subject(), Property::bound_dominates_contribution, on),
            std::nullopt);
  EXPECT_NE(failure_of(*mutant_named("intensity-of-representative")->subject(),
                       Property::bound_dominates_contribution, on),
            std::nullopt);
}

} // namespace
} // namespace lightcuts::oracle
