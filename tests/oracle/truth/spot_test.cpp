// SPDX-License-Identifier: MIT
#include <oracle/truth/kinds/spot.h>

#include <cmath>

#include <gtest/gtest.h>
#include <lightcuts/core/kinds/light_kinds.h>
#include <oracle/truth/kinds.h>
#include <oracle/truth/radiometry.h>

namespace lightcuts::oracle {
namespace {

using SpotTruth = radiometry::KindTruth<LightKind::spot>;

/// Calls f(light, x, way) for many spots as they are drawn.
template <class F>
void for_each_drawn(F&& f) {
  gen::Dice dice(11);
  for (int i = 0; i < 20'000; ++i) {
    const glm::vec3 x = dice.in_cube();
    Light light{.kind = LightKind::spot, .position = dice.in_cube()};
    SpotTruth::finish(dice, light, x);
    f(light, x, ShadingPoint(x, {0, 0, 1}, {0, 0, 1}, {}));
  }
}

TEST(SpotTruth, draws_rims_down_to_what_floats_can_tell) {
  int narrow = 0, one_step = 0, on_ramp = 0, narrow_cone = 0;
  for_each_drawn([&](const Light& light, const glm::vec3& x, const ShadingPoint&) {
    ASSERT_LT(light.cos_outer, light.cos_inner);
    const double width = double(light.cos_inner) - light.cos_outer;
    const double t = SpotTruth::emission<long double>(
        light, x, glm::length(glm::dvec3(x) - glm::dvec3(light.position)));
    narrow += width < 0x1p-10 ? 1 : 0;
    one_step += light.cos_outer == std::nextafter(light.cos_inner, -2.0F) ? 1 : 0;
    on_ramp += width < 0x1p-10 && t > 0 && t < 1 ? 1 : 0;
    narrow_cone += light.cos_outer > 1 - 1e-6F ? 1 : 0; // 0.1 degrees
  });
  EXPECT_GT(narrow, 4000);
  EXPECT_GT(one_step, 1500);
  EXPECT_GT(on_ramp, 800);
  EXPECT_GT(narrow_cone, 500);
}

TEST(SpotTruth, and_the_library_agree_with_700_bits) {
  double worst_truth = 0, worst_library = 0;
  for_each_drawn([&](const Light& light, const glm::vec3& x, const ShadingPoint& point) {
    const radiometry::Way<Exact> exact_way(point, light);
    const radiometry::Way<long double> way(point, light);
    const Exact exact = SpotTruth::emission<Exact>(light, x, exact_way.distance);
    const Exact truth = SpotTruth::emission<long double>(light, x, way.distance);
    const Exact own = emission(light, x);
    ASSERT_EQ(exact == 0, truth == 0);
    ASSERT_EQ(exact == 0, own == 0);
    if (exact == 0) return;
    worst_truth = std::max(worst_truth, double(abs(Exact(truth - exact)) / exact));
    worst_library = std::max(worst_library, double(abs(Exact(own - exact)) / exact));
  });
  EXPECT_LT(worst_truth, truth_error);
  EXPECT_LT(worst_library, emission_error);
}

} // namespace
} // namespace lightcuts::oracle
