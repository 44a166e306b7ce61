// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lightcuts/render/view/renderer.h>
#include <oracle/cases/random_case.h>
#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto pixels = Property::pixels_equal_points;
constexpr auto occlusion = Property::occlusion_equals_brute_force;
constexpr auto finite_pictures = Property::results_are_finite;

/// A floor, and one light above it; the camera looks at both from above. With a roof the light is
/// hidden from part of the floor.
Case floor_case(bool roof) {
  Case c;
  c.lights.resize(1);
  c.lights[0].position = {0.5F, 2, 0.25F};
  c.lights[0].intensity = glm::vec3(1, 2, 3);
  c.views.resize(1);
  c.views[0].view.material = {glm::vec3(0.5F), {}};
  const glm::vec3 a(-4, 0, 4), b(4, 0, 4), d(4, 0, -4), e(-4, 0, -4);
  c.triangles = {{a, b, d, 0}, {a, d, e, 0}};
  if (roof) c.triangles.push_back({{0, 1, 1}, {2, 1, 1}, {1, 1, -1}, 1});
  c.camera = {{0, 6, 1}, glm::vec3(0), {0, 1, 0}, 40};
  c.image_size = {6, 5};
  return c;
}

/// The library, but for pictures and occlusion that a test makes of its own.
class Painter : public KernelSubject {
public:
  std::function<void(Rendering&)> paint = [](Rendering&) {};
  std::function<bool(bool own, std::uint32_t light)> look = [](bool own, std::uint32_t) {
    return own;
  };
  Parts judged = library_parts;

  Painter() : KernelSubject("painter") {}
  [[nodiscard]] Parts parts() const override { return judged; }
  [[nodiscard]] Rendering render(const SceneView& view, const LightTree& tree,
                                 const RenderConfig& config) const override {
    Rendering picture = KernelSubject::render(view, tree, config);
    paint(picture);
    return picture;
  }
  [[nodiscard]] bool sees(const SceneView& view, const VisiblePoint& from,
                          std::uint32_t light) const override {
    return look(KernelSubject::sees(view, from, light), light);
  }
};

Tally judged_pictures(const Subject& subject, const Case& on) {
  Tally tally;
  Judge(subject.parts(), 0, tally).picture(subject, on);
  return tally;
}

TEST(PictureProperties, HoldForTheLibrary) {
  for (const bool roof : {false, true}) {
    const Tally tally = judged_pictures(*library_subject(), floor_case(roof));
    EXPECT_THAT(violated(tally), IsEmpty());
    EXPECT_EQ(tally[pixels].cases, 30U);
    EXPECT_EQ(tally[finite_pictures].cases, 30U);
    EXPECT_GT(tally[occlusion].cases, 20U);
  }
}

TEST(PictureProperties, HoldForTheLibraryInRandomCases) {
  Tally tally;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Case c = random_case(5, i);
    if (!c.triangles.empty()) Judge(library_parts, i, tally).picture(*library_subject(), c);
  }
  for (const Property p : {pixels, finite_pictures, occlusion}) {
    EXPECT_EQ(tally[p].first_violation, "") << info(p).name;
    EXPECT_GT(tally[p].cases, 1000U) << info(p).name;
  }
}

TEST(PictureProperties, ConvictOnePixelThatIsOneUlpOff) {
  Painter subject;
  subject.paint = [](Rendering& picture) {
    float& green = picture.radiance[2 * 6 + 3].y;
    green = std::nextafter(green, 0.0F);
  };
  const Tally tally = judged_pictures(subject, floor_case(false));
  EXPECT_THAT(violated(tally), ElementsAre(pixels));
  EXPECT_EQ(tally[pixels].violations, 1U);
  EXPECT_THAT(tally[pixels].first_violation, HasSubstr("pixel (3, 2)"));
}

TEST(PictureProperties, ConvictAPictureThatIsUpsideDown) {
  Painter subject;
  subject.paint = [](Rendering& picture) {
    std::reverse(picture.radiance.begin(), picture.radiance.end());
  };
  EXPECT_THAT(violated(judged_pictures(subject, floor_case(false))), ElementsAre(pixels));
}

TEST(PictureProperties, ConvictLightWhereNothingIsSeen) {
  Painter subject;
  Case away = floor_case(false);
  away.camera.target = {0, 12, 1.5F};
  EXPECT_THAT(violated(judged_pictures(subject, away)), IsEmpty());
  subject.paint = [](Rendering& picture) { picture.radiance.back().x = 1; };
  EXPECT_THAT(violated(judged_pictures(subject, away)), ElementsAre(pixels));
}

TEST(PictureProperties, ConvictNumbersThatAreNone) {
  Painter subject;
  for (const float bad : {std::nanf(""), -1.0F}) {
    subject.paint = [bad](Rendering& picture) { picture.radiance[7].z = bad; };
    const Tally tally = judged_pictures(subject, floor_case(false));
    EXPECT_THAT(violated(tally), ElementsAre(finite_pictures, pixels));
    EXPECT_EQ(tally[finite_pictures].violations, 1U);
  }
}

TEST(PictureProperties, ConvictShadowsThatAreMissingOrTooMany) {
  Painter subject;
  subject.look = [](bool, std::uint32_t) { return true; };
  EXPECT_THAT(violated(judged_pictures(subject, floor_case(false))), IsEmpty());
  EXPECT_THAT(judged_pictures(subject, floor_case(true))[occlusion].first_violation,
              HasSubstr("seen, by brute force blocked"));
  subject.look = [](bool, std::uint32_t) { return false; };
  EXPECT_THAT(judged_pictures(subject, floor_case(false))[occlusion].first_violation,
              HasSubstr("blocked, by brute force seen"));
}

TEST(PictureProperties, AskForPartsThatThereAreOnly) {
  Painter subject;
  subject.judged = only(Part::occlusion);
  EXPECT_EQ(judged_pictures(subject, floor_case(true))[pixels].cases, 0U);
  EXPECT_GT(judged_pictures(subject, floor_case(true))[occlusion].cases, 0U);
  subject.judged = only(Part::pictures);
  EXPECT_EQ(judged_pictures(subject, floor_case(true))[pixels].cases, 30U);
  EXPECT_EQ(judged_pictures(subject, floor_case(true))[occlusion].cases, 0U);
}

// A light behind the surface is not asked for, as no ray is ever cast to it.
TEST(CheckRay, IsNotAskedOfLightsBelowTheHorizon) {
  Case c = floor_case(true);
  c.lights[0].position.y = -2;
  EXPECT_EQ(judged_pictures(Painter(), c)[occlusion].cases, 0U);
}

TEST(CheckRay, CountsRaysThatAreTooCloseToCall) {
  const Case c = floor_case(true);
  const Scene scene = c.scene();
  const SceneView view(scene);
  RayCount count;
  Tally tally;
  const Painter subject;
  const Judge judge(library_parts, 0, tally);
  for (unsigned y = 0; y < 5; ++y)
    for (unsigned x = 0; x < 6; ++x)
      if (const auto p = view.at({x, y})) judge.ray({subject, view, *p, 0, count});
  EXPECT_GT(count.rays, 0U);
  EXPECT_EQ(count.rays, count.undecided + tally[occlusion].cases);
}

} // namespace
} // namespace lightcuts::oracle
