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
      {.position = {0x1.99999ap-4F, 0x0p+0F, 0x1p+0F}, .intensity = {0x1p+0F, 0x1p+1F, 0x1.8p+1F}},
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
      {.kind = LightKind::profile,
       .position = {0x0p+0F, 0x1p+1F, 0x1p+0F},
       .intensity = {0x1p+0F, 0x1p-1F, 0x1p+1F},
       .axis = {0x0p+0F, 0x0p+0F, -0x1p+0F},
       .plane = {0x0p+0F, 0x1p+0F, 0x0p+0F},
       .profile = Profile({.cosines = {0x1p+0F, 0x1p-1F, -0x1p+0F},
                           .plane_cosines = {0x1p+0F, -0x1p-1F, -0x1p-1F},
                           .plane_sines = {0x0p+0F, 0x1.bb67aep-1F, -0x1.bb67aep-1F},
                           .shares = {0x1p+0F, 0x1p-1F, 0x0p+0F, 0x1p+0F, 0x1.8p-1F, 0x1p-2F,
                                      0x1p+0F, 0x1p-3F, 0x0p+0F}})},
  };
  on.min_distance = 0x1p-4F;
  on.views = {
      {.view = {.material = {.diffuse = {0x1p-1F, 0x1p-1F, 0x1p-1F},
                             .lobe = Phong{.reflectance = {0x1p-2F, 0x1p-2F, 0x1p-2F},
                                           .exponent = 0x1p+3F}}},
       .hidden = {1U, 2U}},
      {.view = {.position = {0x0p+0F, 0x1p+0F, 0x0p+0F},
                .to_viewer = {0x0p+0F, 0x1.333334p-1F, 0x1.99999ap-1F},
                .material = {.diffuse = {0x1p-1F, 0x1p-1F, 0x1p-1F},
                             .lobe = Ward{.reflectance = {0x1p-1F, 0x1p-1F, 0x1p-1F},
                                          .alpha = 0x1p-2F}}}},
      {.view = {.position = {0x1p+0F, 0x0p+0F, 0x0p+0F},
                .material = {.diffuse = {0x1.99999ap-4F, 0x1.99999ap-4F, 0x1.99999ap-4F},
                             .lobe = CookTorrance{.f0 = {0x1.47ae14p-5F, 0x1.47ae14p-5F,
                                                         0x1.47ae14p-5F}}}},
       .hidden = {0U}},
      {.view = {.position = {0x1p+0F, 0x1p+0F, 0x0p+0F}}},
  };
  on.cut = {.threshold = 0x1.99999ap-4F, .max_size = 7U, .black_level = 0x1.0624dep-10F};
  on.seed = 12345678901234567890U;
  on.triangles = {
      {.a = {-0x1p+2F, -0x1p+2F, 0x0p+0F},
       .b = {0x1p+2F, -0x1p+2F, 0x0p+0F},
       .c = {0x0p+0F, 0x1p+2F, 0x0p+0F}},
      {.a = {0x0p+0F, 0x0p+0F, 0x1p-1F},
       .b = {0x1p+0F, 0x0p+0F, 0x1p-1F},
       .c = {0x0p+0F, 0x1p+0F, 0x1p-1F},
       .mesh = 3U},
  };
  on.camera = {.position = {0x0p+0F, -0x1.8p+1F, 0x1.8p+1F},
               .up = {0x0p+0F, 0x0p+0F, 0x1p+0F},
               .vertical_fov = 0x1.9p+5F};
  on.image_size = {3U, 2U};
  EXPECT_EQ(failure_of(*library_subject(), Property::bound_dominates_contribution, on),
            std::nullopt);
  EXPECT_NE(failure_of(*mutant_named("intensity-of-representative")->subject(),
                       Property::bound_dominates_contribution, on),
            std::nullopt);
}

} // namespace
} // namespace lightcuts::oracle
