// SPDX-License-Identifier: MIT
#include <lightcuts/core/shading/sight.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <oracle/truth/radiometry.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Exact;
using Way = oracle::radiometry::Way<Exact>;

// e^-700 is the least that a lobe can tell from 0.
const double largest_tangent = std::sqrt(700);

Exact length(const glm::vec3& v) { return sqrt(precise::distance2(glm::vec3(0), v)); }

/// (1 - v.h)^5 by |l + v| = 2 v.h.
Exact real_schlick(const ShadingPoint& point, const Way& way) {
  Exact sum2 = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact part = way.q[std::size_t(i)] / way.distance +
                       Exact(point.to_viewer()[i]) / length(point.to_viewer());
    sum2 += precise::square(part);
  }
  const Exact w = 1 - sqrt(sum2) / 2;
  return w * precise::square(precise::square(w));
}

/// For every light above the horizon of a scene that one in two times is seen along its surface.
template <class Check>
void for_lights_above(Check&& check) {
  const gen::Scene scene = *rc::gen::oneOf(gen::scene(), gen::grazing_scene());
  const ShadingPoint point = scene.view.point();
  for (const Light& light : scene.lights) {
    const Sight sight(point, light.kind, light.position);
    if (!sight.below_horizon()) check(point, sight, Way(point, light));
  }
}

RC_GTEST_PROP(Sight, KnowsTheHalfVectorsTangentWithinTheStatedError, ()) {
  for_lights_above([](const ShadingPoint& point, const Sight& sight, const Way& way) {
    if (point.viewer_cosine() <= 0) return;
    const Exact exact = sqrt(oracle::radiometry::half_tangent2(way));
    const double tangent = std::sqrt(sight.half_tangent2());
    RC_ASSERT(!std::isnan(tangent));
    if (exact > largest_tangent)
      RC_ASSERT(tangent > 0.99 * largest_tangent);
    else
      RC_ASSERT(abs(Exact(tangent) - exact) <= 0x1.bp-48 + 0x1p-41 * exact);
  });
}

RC_GTEST_PROP(Sight, KnowsSchlicksTermWithinTheStatedError, ()) {
  for_lights_above([](const ShadingPoint& point, const Sight& sight, const Way& way) {
    const Exact exact = real_schlick(point, way);
    RC_ASSERT(abs(Exact(sight.schlick()) - exact) <= 0x1p-31 * exact + Exact(1e-300));
  });
}

// Viewer and light mirror each other: h is the normal, and T is 0.
TEST(Sight, SeesNoTangentBetweenMirrorImagesAtAnyHeight) {
  for (int e = 1; e <= 149; ++e)
    for (const float x : {0.0F, 0.3F, 0.6F}) {
      const float up = std::ldexp(1.0F, -e);
      const glm::vec3 v(x, up, std::sqrt(1 - double(x) * x - double(up) * up));
      const ShadingFrame frame(glm::vec3(0), {0, 1, 0}, v);
      const Sight sight(frame, LightKind::omni, {-2 * v.x, 2 * v.y, -2 * v.z});
      EXPECT_LE(sight.half_tangent2(), 0x1p-94) << "n.v = 2^-" << e;
    }
}

// What differs in the last bit floats have: h is as far from the normal as n.v is from n.l.
TEST(Sight, SeesWhatIsLeftOfTheHalfVectorAtTheHorizon) {
  constexpr float tiny = 0x1p-149F;
  for (int i = -40; i <= 40; ++i) { // lengths from which some are not rounded to 1
    const float z = 1 + float(i) * 0x1p-22F;
    const ShadingFrame frame(glm::vec3(0), {0, 1, 0}, {0, tiny, z});
    const auto tangent2_of = [&](const glm::vec3& y) {
      return Sight(frame, LightKind::omni, y).half_tangent2();
    };
    EXPECT_EQ(tangent2_of({0, tiny, -z}), 0);
    EXPECT_NEAR(tangent2_of({tiny, tiny, -z}), 0.25, 1e-12); // aside by 1, up by 2
    EXPECT_NEAR(tangent2_of({3 * tiny, 2 * tiny, -z}), 1, 1e-12);
    EXPECT_LT(tangent2_of({0, 2 * tiny, -z}), 1e-80); // within the plane of incidence
  }
}

// The light is higher than the viewer, within the plane of incidence: T is half the difference.
TEST(Sight, SeesNothingButTheDifferenceOfHeightsInThePlaneOfIncidence) {
  for (const float x : {0.1F, 0.3F, 0.45F, 0.6F, 0.7F})
    for (const int e : {30, 60, 100, 148}) {
      const float up = std::ldexp(1.0F, -e);
      const glm::vec3 v(x, up, std::sqrt(1 - double(x) * x));
      const ShadingFrame frame(glm::vec3(0), {0, 1, 0}, v);
      const Sight sight(frame, LightKind::omni, {-v.x, 3 * up, -v.z});
      EXPECT_NEAR(std::sqrt(sight.half_tangent2()) / up, 1, 1e-6) << "n.v = 2^-" << e;
    }
}

} // namespace
} // namespace lightcuts
