// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/sum_lights.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/kernels/transfer.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;

RC_GTEST_PROP(SumLights, IsTheExactSumButForRounding, ()) {
  const gen::Scene scene = *gen::scene();
  const auto mask = *rc::gen::arbitrary<std::uint32_t>();
  const auto visible = [mask](std::uint32_t i) { return ((mask >> (i % 32)) & 1U) == 0; };
  const LightSet lights = scene.light_set();
  const ShadingPoint point = scene.view.point();
  const Colour exact = precise::sum(lights, point, visible);
  const LightSum sum = sum_lights(lights, point, visible);
  // As stated with the function. transfer() may lose what is below least_transfer; times the
  // largest intensity, and for each light, that is below 10^-80.
  const Quad relative = Quad(transfer_error) + lights.size() * Quad(0x1p-53);
  for (int c = 0; c < 3; ++c)
    RC_ASSERT(abs(Quad(sum.radiance[c]) - exact[c]) <= exact[c] * relative + Quad(1e-80));
}

RC_GTEST_PROP(SumLights, AsksForVisibilityOnceOfEachLightAboveTheHorizon, ()) {
  const gen::Scene scene = *gen::scene();
  const LightSet lights = scene.light_set();
  const ShadingPoint point = scene.view.point();
  std::vector<int> calls(lights.size());
  const LightSum sum = sum_lights(lights, point, [&](std::uint32_t i) { return ++calls[i] > 0; });
  std::uint32_t total = 0;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const bool sends = transfer(point, lights[i], lights.min_distance()) != glm::dvec3(0);
    RC_ASSERT(calls[i] == (sends ? 1 : 0));
    total += sends ? 1 : 0;
  }
  RC_ASSERT(sum.shadow_rays == total);
}

TEST(SumLights, OfNoLightsIsBlack) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const LightSum sum = sum_lights({}, point, [](std::uint32_t) { return true; });
  EXPECT_EQ(sum.radiance, glm::dvec3(0));
  EXPECT_EQ(sum.shadow_rays, 0U);
}

} // namespace
} // namespace lightcuts
