// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/material.h>

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <oracle/truth/reciprocity.h>
#include <oracle/truth/white_furnace.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using oracle::BothWays;
using oracle::Furnace;
using oracle::white_furnace;

// Lobes from one end of the domain of their width to the other.
constexpr std::array alphas{0x1p-14F, 0.001F, 0.01F, 0.05F, 0.1F, 0.3F, 0.5F, 0.7F, 1.0F};
constexpr std::array exponents{0.0F, 0.5F, 1.0F, 10.0F, 100.0F, 10000.0F, Phong::max_exponent};
std::vector<NoLobe> widths(NoLobe) { return {{}}; }
std::vector<Phong> widths(Phong) {
  std::vector<Phong> list;
  for (const float e : exponents) list.push_back({glm::vec3(1), e});
  return list;
}
template <class Microfacets>
std::vector<Microfacets> widths(Microfacets) {
  std::vector<Microfacets> list;
  for (const float a : alphas) list.push_back({glm::vec3(1), a});
  return list;
}

constexpr std::array viewer_angles{0.0,  10.0, 30.0, 45.0, 60.0,  75.0,
                                   85.0, 88.0, 89.0, 89.5, 89.73, 89.9};

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::string width_of(const NoLobe&) { return "diffuse"; }
std::string width_of(const Phong& phong) { return "exponent " + std::to_string(phong.exponent); }
template <class Microfacets>
std::string width_of(const Microfacets& lobe) {
  return "alpha " + std::to_string(lobe.alpha);
}

template <class OneLobe>
class Brdf : public testing::Test {
protected:
  /// For every width and angle of the viewer, in degrees.
  template <class Check>
  static void for_all(Check&& check) {
    for (const OneLobe& lobe : widths(OneLobe{}))
      for (const double degrees : viewer_angles) {
        SCOPED_TRACE(width_of(lobe) + ", viewer at " + std::to_string(degrees));
        check(lobe, degrees);
      }
  }
};

template <class Variant>
struct AllOf;
template <class... Lobes>
struct AllOf<std::variant<Lobes...>> {
  using Types = testing::Types<Lobes...>;
};

struct Names {
  template <class OneLobe>
  static std::string GetName(int) {
    constexpr const char* names[] = {"Diffuse", "Phong", "Ward", "CookTorrance"};
    return names[Lobe(OneLobe{}).index()];
  }
};

TYPED_TEST_SUITE(Brdf, AllOf<Lobe>::Types, Names);

/// Above the surface, if it is not in it.
glm::vec3 above(const glm::vec3& n, const glm::vec3& v) {
  return exact_dot(n, glm::vec3(0), v) < 0 ? -v : v;
}

TYPED_TEST(Brdf, IsReciprocal) {
  const auto scenes = gen::scene_of(LightKind::directional, Lobe(TypeParam{}).index(), false, 1);
  EXPECT_TRUE(rc::check("f(l,v) = f(v,l)", [&] {
    const gen::Scene scene = *scenes;
    const glm::vec3& n = scene.view.normal;
    const glm::vec3 l = above(n, scene.lights[0].position), v = above(n, scene.view.to_viewer);
    RC_PRE(exact_dot(n, glm::vec3(0), l) > 0 && exact_dot(n, glm::vec3(0), v) > 0);
    const BothWays f = oracle::both_ways(scene.view.material, n, l, v);
    for (int c = 0; c < 3; ++c) RC_ASSERT(std::abs(f.there[c] - f.back[c]) <= f.allowed[c]);
  }));
}

TYPED_TEST(Brdf, ConservesEnergyInAWhiteFurnace) {
  this->for_all([](const TypeParam& lobe, double degrees) {
    const Furnace f = white_furnace(lobe, radians(degrees), 128);
    EXPECT_LE(f.value, oracle::most_reflected(lobe, std::cos(radians(degrees))) + f.error);
    EXPECT_GT(f.value, 0);
    EXPECT_LE(f.error, 0.01 * std::max(1.0, f.value));
  });
}

// Sixteen times as many points tell the error of the quadrature that the oracle uses.
TYPED_TEST(Brdf, IsIntegratedWithinTheStatedError) {
  this->for_all([](const TypeParam& lobe, double degrees) {
    const Furnace f = white_furnace(lobe, radians(degrees), 64);
    const Furnace finer = white_furnace(lobe, radians(degrees), 256);
    EXPECT_LE(std::abs(f.value - finer.value), f.error);
  });
}

// Of a lobe that is not sharp: over the hemisphere's angles, without a density that follows it.
TYPED_TEST(Brdf, HasTheIntegralThatASimpleSumGives) {
  const std::vector<TypeParam> lobes = widths(TypeParam{});
  const Material material = oracle::white(lobes.back());
  const TypeParam wide = std::get<TypeParam>(
      std::holds_alternative<Phong>(material.lobe) ? Lobe(Phong{glm::vec3(1), 10}) : material.lobe);
  const glm::vec3 v(oracle::density::around_z(std::cos(radians(40)), 0));
  const ShadingPoint point(glm::vec3(0), {0, 0, 1}, v, oracle::white(wide));
  constexpr int rings = 400, sectors = 400;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      // Equal areas: z is uniform.
      const glm::vec3 l(
          oracle::density::around_z((i + 0.5) / rings, radians(360) * (j + 0.5) / sectors));
      sum += transfer(point, {.kind = LightKind::directional, .position = l}).x;
    }
  EXPECT_NEAR(sum * radians(360) / (rings * sectors), white_furnace(wide, radians(40), 256).value,
              1e-3);
}

// What the headers say of energy.
TEST(BrdfEnergy, OfADiffuseSurfaceIsAllFromAnywhere) {
  for (const double degrees : viewer_angles)
    EXPECT_NEAR(white_furnace(NoLobe(), radians(degrees)).value, 1, 1e-6);
}

TEST(BrdfEnergy, OfPhongIsAllAlongTheNormal) {
  for (const Phong& phong : widths(Phong{})) {
    const Furnace f = white_furnace(phong, 0, 256);
    EXPECT_NEAR(f.value, 1, f.error);
    EXPECT_LT(white_furnace(phong, radians(30), 256).value, 0.94);
  }
}

TEST(BrdfEnergy, OfSharpWardIsTheViewersCosine) {
  for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
    const Furnace f = white_furnace(Ward{glm::vec3(1), Ward::min_alpha}, radians(degrees));
    EXPECT_NEAR(f.value, std::cos(radians(degrees)), f.error);
  }
}

TEST(BrdfEnergy, OfWardExceedsAllNearTheHorizonByNoMoreThanStated) {
  for (const float alpha : {0.01F, 0.1F, 0.3F, 0.7F, 0.8F, 1.0F}) {
    const Ward ward{glm::vec3(1), alpha};
    // The stated factor is within 9 % of what is needed at some cosine, if alpha is 0.1 or less, or
    // about 0.7.
    double nearest = 0;
    for (const double cosine : {0x1p-8, 0x1p-10, 0x1p-14, 0x1p-20, 0x1p-24}) {
      const Furnace f = white_furnace(ward, std::acos(cosine), 256);
      EXPECT_LE(f.value, oracle::most_reflected(ward, cosine) + f.error) << alpha << " " << cosine;
      if (f.value > 1) nearest = std::max(nearest, f.value / oracle::most_reflected(ward, cosine));
    }
    const bool is_tight = alpha == 0.01F || alpha == 0.1F || alpha == 0.7F;
    EXPECT_GT(nearest, is_tight ? 0.91 : 0) << alpha;
  }
}

TEST(BrdfEnergy, OfCookTorranceLacksWhatScattersTwice) {
  EXPECT_NEAR(white_furnace(CookTorrance{glm::vec3(1), 1}, 0, 256).value, 0.307, 0.001);
}

} // namespace
} // namespace lightcuts
