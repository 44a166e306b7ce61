// SPDX-License-Identifier: MIT
#include <oracle/truth/truth.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

Light omni(const glm::vec3& position, const glm::vec3& intensity) {
  return {.position = position, .intensity = intensity};
}

/// Whether value is within truth_error of exact, or below what long double can say.
bool agrees(long double value, const Exact& exact) {
  if (exact < std::numeric_limits<long double>::min()) return value < 1e-4900L;
  return abs(Exact(value) - exact) <= exact * Exact(truth_error);
}

void expect_agreement(const Light& light, const ShadingPoint& point) {
  const Wide value = contribution(light, point, 0);
  for (int c = 0; c < 3; ++c) {
    const Exact exact = exact_contribution(light, point, 0, c);
    EXPECT_GT(exact, 0);
    EXPECT_TRUE(agrees(value[c], exact)) << double(value[c]) << " against " << exact;
  }
}

RC_GTEST_PROP(Truth, InLongDoubleIsWithinItsErrorOfTheExactOne, ()) {
  const gen::Scene scene = *gen::scene(4);
  const ShadingPoint point = scene.view.point();
  for (const Light& light : scene.lights) {
    const Wide value = contribution(light, point, scene.min_distance);
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(agrees(value[c], exact_contribution(light, point, scene.min_distance, c)));
  }
}

/// The BRDFs by other formulas than the definitions': with h itself, its angles and e-functions.
TEST(Truth, EqualsTheBrdfsWrittenWithTheHalfVector) {
  gen::Dice dice(9);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 n(0, 0, 1);
    const auto above = [&] {
      glm::vec3 v = glm::normalize(dice.in_cube());
      v.z = std::abs(v.z);
      return v;
    };
    const glm::vec3 v = above(), l = above();
    if (v.z < 0.05F || l.z < 0.05F) continue;
    const glm::dvec3 h =
        glm::normalize(glm::normalize(glm::dvec3(l)) + glm::normalize(glm::dvec3(v)));
    const double nh = h.z, nl = glm::normalize(glm::dvec3(l)).z,
                 nv = glm::normalize(glm::dvec3(v)).z;
    const double vh = glm::dot(glm::normalize(glm::dvec3(v)), h), alpha = 0.3,
                 a2 = double(0.3F) * 0.3F;
    const double tan2 = (1 - nh * nh) / (nh * nh);
    const double ward = std::exp(-tan2 / a2) / (4 * std::numbers::pi * a2 * std::sqrt(nl * nv));
    const double d = a2 / (std::numbers::pi * std::pow(nh * nh * (a2 - 1) + 1, 2));
    const auto lambda = [a2](double c) {
      return 0.5 * (std::sqrt(1 + a2 * (1 - c * c) / (c * c)) - 1);
    };
    const double g = 1 / (1 + lambda(nl) + lambda(nv));
    const double f = double(0.04F) + (1 - double(0.04F)) * std::pow(1 - vh, 5);
    const double cook = f * d * g / (4 * nl * nv);
    const Light sun{.kind = LightKind::directional, .position = l, .intensity = glm::vec3(1)};
    const auto of = [&](const Lobe& lobe) {
      return double(contribution(sun, {{5, 6, 7}, {0, 0, 1}, v, {{}, lobe}}, 0)[0]);
    };
    // Far from the peak the logarithm of what is compared amplifies double's rounding.
    if (ward > 1e-30) {
      EXPECT_NEAR(of(Ward{glm::vec3(1), float(alpha)}) / (ward * nl), 1, 1e-10);
    }
    EXPECT_NEAR(of(CookTorrance{glm::vec3(0.04F), float(alpha)}) / (cook * nl), 1, 1e-10);
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Truth, IsAccurateAtGrazingLight) {
  const Light grazing = omni({1e15F, -1e15F, 0x1p-149F}, glm::vec3(1));
  expect_agreement(grazing, diffuse_point());
}

// n.y and n.x agree to 24 bits and cancel.
TEST(Truth, IsAccurateFarFromTheOrigin) {
  const Material glossy{glm::vec3(0.5F), Phong{glm::vec3(0.5F), 100}};
  const ShadingPoint far({1e8F, 1e8F, 1e8F}, {0.6F, 0, 0.8F}, {0, 0.6F, 0.8F}, glossy);
  expect_agreement(omni({1e8F + 8, 1e8F, 1e8F}, glm::vec3(1)), far);
}

TEST(Truth, IsAccurateWhereTheDotProductCancelsAltogether) {
  const glm::vec3 normal(0.6F, -0.8F, 0x1p-100F);
  const ShadingPoint point(glm::vec3(0), normal, normal, {glm::vec3(1), {}});
  // 0.6F a - 0.8F b is 0 here, and what is left is 2^-100.
  expect_agreement(omni({0.8F, 0.6F, 1}, glm::vec3(1)), point);
}

// 2^80 and 2^10 cancel, and leave 2^-70: more than a sum of twice the precision can say.
TEST(Truth, IsAccurateWhereEvenTheCompensatedSumCancels) {
  const glm::vec3 diagonal(std::sqrt(1 / 3.0F));
  const ShadingPoint point({-0x1p10F, 0x1p10F, 0}, diagonal, diagonal, {glm::vec3(1), {}});
  expect_agreement(omni({0x1p80F, 0x1p-70F, -0x1p80F}, glm::vec3(1)), point);
}

TEST(Truth, IsAccurateAtTheLargestExponent) {
  const Material mirror{glm::vec3(0), Phong{glm::vec3(1), Phong::max_exponent}};
  const ShadingPoint point(glm::vec3(0), {0, 0, 1}, {0, 0, 1}, mirror);
  expect_agreement(omni({0.001F, 0, 1}, glm::vec3(1)), point);
  expect_agreement(omni({0.05F, 0.01F, 1}, glm::vec3(1)), point); // 10^-592
}

/// A light that mirrors the viewer at the plane y = 0, both at this height: of so few bits that it
/// can be exactly three times as far.
struct MirrorImages {
  ShadingPoint point;
  Light light;

  MirrorImages(float height, const Lobe& lobe)
      : point(glm::vec3(0), {0, 1, 0}, viewer(height), {glm::vec3(0), lobe}),
        light(omni({-3 * viewer(height).x, 3 * height, -3 * viewer(height).z}, glm::vec3(1))) {}

private:
  static glm::vec3 viewer(float height) {
    const double z = std::sqrt(1 - 0.25 * 0.25 - double(height) * height);
    return {0.25F, height, std::round(z * 0x1p20) * 0x1p-20};
  }
};

long double length_of(const glm::vec3& v) {
  return std::sqrt(static_cast<long double>(v.x) * v.x + static_cast<long double>(v.y) * v.y +
                   static_cast<long double>(v.z) * v.z);
}

// h is the normal: nothing is left of Ward's exponential and of D's tangent.
TEST(Truth, IsThatOfTheNormalBetweenMirrorImagesAtAnyHeight) {
  const long double pi = std::acos(-1.0L), alpha = 0x1p-14L;
  for (int e = 1; e <= 149; ++e) {
    const float height = std::ldexp(1.0F, -e);
    const MirrorImages ward(height, Ward{glm::vec3(1), 0x1p-14F});
    const MirrorImages facets(height, CookTorrance{glm::vec3(1), 0x1p-14F});
    const long double length = length_of(ward.point.to_viewer());
    const long double cosine = height / length, square = 9 * length * length;
    const long double of_ward = 1 / (4 * pi * alpha * alpha) / square;
    const long double masked = std::sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
    const long double of_facets = 1 / (pi * alpha * alpha) / (4 * masked) / square;
    const auto check = [&](const MirrorImages& images, long double expected) {
      const long double most = expected * 0x1p-50L;
      EXPECT_LE(std::abs(contribution(images.light, images.point, 0)[0] - expected), most) << e;
      const Exact exact = exact_contribution(images.light, images.point, 0, 0);
      EXPECT_LE(abs(exact - Exact(expected)), Exact(most)) << e;
    };
    check(ward, of_ward);
    check(facets, of_facets);
  }
}

RC_GTEST_PROP(Truth, InLongDoubleIsWithinItsErrorNearTheHorizon, ()) {
  const gen::Scene scene = *gen::grazing_scene();
  const ShadingPoint point = scene.view.point();
  for (const Light& light : scene.lights) {
    const Wide value = contribution(light, point, scene.min_distance);
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(agrees(value[c], exact_contribution(light, point, scene.min_distance, c)));
  }
}

TEST(Truth, HasNoContributionFromBehindOrFromThePointItself) {
  for (const glm::vec3& y : {glm::vec3(1, 0, -1), glm::vec3(1, 2, 0), glm::vec3(0)}) {
    EXPECT_EQ(contribution(omni(y, glm::vec3(1)), diffuse_point(), 0), Wide{});
    EXPECT_EQ(exact_contribution(omni(y, glm::vec3(1)), diffuse_point(), 0, 0), 0);
  }
}

TEST(Truth, OfALightOverhead) {
  const Wide value = contribution(omni({0, 0, 2}, {1, 2, 4}), diffuse_point(), 0);
  const long double red = 0.5L / 4 / std::acos(-1.0L);
  for (int c = 0; c < 3; ++c) EXPECT_LE(std::abs(value[c] / (red * (1 << c)) - 1), truth_error);
}

RC_GTEST_PROP(Truth, OfAClusterIsTheSumOverItsLights, ()) {
  const gen::Scene scene = *gen::scene(12);
  LightTree tree = build(scene.light_set());
  const auto mask = *rc::gen::arbitrary<std::uint32_t>();
  std::vector<char> visible;
  for (std::size_t i = 0; i < tree.lights().size(); ++i) visible.push_back((mask >> i) & 1U);
  const JudgedPoint judged(std::move(tree), scene.view.point(), visible);
  for (std::uint32_t node = 0; node < judged.tree.nodes().size(); ++node)
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(agrees(judged.truth.open(node)[c], judged.truth.exact_open(node, c)));
      RC_ASSERT(agrees(judged.truth.seen(node)[c], judged.truth.exact_seen(node, c)));
    }
  Exact open = 0, seen = 0;
  for (std::uint32_t i = 0; i < visible.size(); ++i) {
    const Exact one =
        exact_contribution(judged.tree.lights()[i], judged.point, scene.min_distance, 1);
    open += one;
    if (visible[i] != 0) seen += one;
  }
  RC_ASSERT(abs(judged.truth.exact_open(0, 1) - open) <= open * Exact(0x1p-600));
  RC_ASSERT(abs(judged.truth.exact_seen(0, 1) - seen) <= seen * Exact(0x1p-600));
}

TEST(Dominates, DecidesTiesToTheLastBit) {
  const float bound = 0.1F;
  for (const long double margin : {0.0L, 0.001L}) {
    const auto decide = [&](float candidate) {
      return dominates(candidate, bound, margin, [&] { return Exact(bound); });
    };
    EXPECT_TRUE(decide(bound));
    EXPECT_TRUE(decide(std::nextafter(bound, 1.0F)));
    EXPECT_FALSE(decide(std::nextafter(bound, 0.0F)));
  }
}

// Long double errs by more than the difference; 700 bits know.
TEST(Dominates, AsksForTheExactValueWithinTheMargin) {
  const Exact above = Exact(1) + ldexp(Exact(1), -300);
  EXPECT_FALSE(dominates(1.0F, 1.0L, 0x1p-40L, [&] { return above; }));
  const Exact below = Exact(1) - ldexp(Exact(1), -300);
  EXPECT_TRUE(dominates(1.0F, 1.0L, 0x1p-40L, [&] { return below; }));
}

TEST(Dominates, DoesNotAskBeyondTheMargin) {
  const auto never = []() -> Exact { throw std::logic_error("asked"); };
  EXPECT_TRUE(dominates(2.0F, 1.0L, 0.5L, never));
  EXPECT_FALSE(dominates(0.25F, 1.0L, 0.5L, never));
}

TEST(Dominates, TakesInfinityForEnoughAndNothingLessThanANumber) {
  const auto huge = [] { return Exact(1e300); };
  EXPECT_TRUE(dominates(inf, 1e300L, 1e290L, huge));
  EXPECT_FALSE(dominates(std::nanf(""), 0, 0, [] { return Exact(0); }));
  EXPECT_FALSE(dominates(-1.0F, 0, 0, [] { return Exact(0); }));
  EXPECT_FALSE(dominates(-inf, 0, 0, [] { return Exact(0); }));
  EXPECT_TRUE(dominates(0.0F, 0, 0, [] { return Exact(0); }));
}

// A truth that is not a number is nothing to be larger than.
TEST(Dominates, IsFalseForAnUnknownValue) {
  const long double nan = std::nanl("");
  EXPECT_FALSE(dominates(1.0F, nan, nan, [] { return Exact(std::nan("")); }));
}

} // namespace
} // namespace lightcuts::oracle
