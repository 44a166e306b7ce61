// SPDX-License-Identifier: MIT
#include <viz/gl/preview/raster_preview.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/renderer.h>

#include <tests/render/support/box_scene.h>
#include <viz/gl/context/offscreen_context.h>

namespace lightcuts::viz {
namespace {

using ::testing::Each;

using Radiance = std::vector<glm::vec3>;
constexpr double long_enough = 1e6; // milliseconds
/// Of difference(): what single precision costs; one light of 200 makes more.
constexpr double rounding_error = 1e-4;

Radiance preview_of(const Scene& scene) {
  RasterPreview preview(scene);
  preview.start(scene.camera, scene.image_size);
  EXPECT_TRUE(preview.advance(long_enough));
  EXPECT_EQ(preview.share(), 1);
  return preview.radiance();
}

/// Every light on its own, emission included.
Radiance reference_of(const Scene& scene) {
  const LightTree tree = build(scene.lights);
  Rendering rendering = render(SceneView(scene), tree, {.method = methods::reference});
  for (std::size_t i = 0; i < rendering.radiance.size(); ++i)
    rendering.radiance[i] += rendering.emission[i];
  return rendering.radiance;
}

float luminance(const glm::vec3& c) { return c.r + c.g + c.b; }

/// The mean over the 99 % of pixels that agree best (others may lie on an edge) of |a - b| / b,
/// with a hundredth of the mean added to b.
double difference(const Radiance& a, const Radiance& b) {
  double mean = 0;
  for (const glm::vec3& c : b) mean += double(luminance(c)) / double(b.size());
  std::vector<double> errors;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const glm::vec3 d = glm::abs(a[i] - b[i]);
    errors.push_back(luminance(d) / (luminance(b[i]) + 0.01 * mean));
  }
  std::sort(errors.begin(), errors.end());
  errors.resize((errors.size() * 99 + 99) / 100);
  double sum = 0;
  for (const double error : errors) sum += error;
  return sum / double(errors.size());
}

/// All lights of `lights` but light i.
LightSet without(const LightSet& lights, std::size_t left_out) {
  LightSet result;
  if (lights.min_distance() > 0) result.set_min_distance(lights.min_distance());
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (i != left_out) result.add(lights[i]);
  return result;
}

/// Texels without any order.
Texture speckled(glm::uvec2 size) {
  std::vector<glm::vec3> texels;
  for (std::uint32_t i = 0; i < size.x * size.y; ++i)
    texels.emplace_back(0.1F * static_cast<float>(i * 7 % 11), 0.2F * static_cast<float>(i * 5 % 7),
                        0.3F * static_cast<float>(i % 3));
  return {size, std::move(texels)};
}

void add_metal_floor(Scene& scene) {
  const std::uint32_t floor = test::add_surface(scene, {0.2F, 0.3F, 0.1F});
  scene.surfaces[floor].material.lobe = CookTorrance{{0.6F, 0.5F, 0.4F}, 0.3F};
  scene.textures.push_back(speckled({5, 3}));
  scene.surfaces[floor].texture = SurfaceTexture{0, {Wrap::mirror, Wrap::repeat}};
  scene.surfaces[floor].tinted_f0 = {0.5F, 0.5F, 0.125F};
  test::add_quad(scene, floor, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
  scene.mesh.uv.resize(scene.mesh.positions.size());
  scene.mesh.uv = {{-1.3F, 0.4F}, {1.9F, 0.4F}, {1.9F, 2.7F}, {-1.3F, 2.7F}};
}

/// A wall that bulges out by its normals, and one that is lit by nothing but itself.
void add_walls(Scene& scene) {
  const std::uint32_t wall = test::add_surface(scene, {0.5F, 0.6F, 0.7F});
  scene.surfaces[wall].material.lobe = CookTorrance{glm::vec3(0.04F), 0.1F};
  test::add_quad(scene, wall, {-2, 0, -2}, {2, 0, -2}, {2, 3, -2}, {-2, 3, -2});
  for (std::size_t i = 4; i < 8; ++i) {
    const glm::vec3 p = scene.mesh.positions[i];
    scene.mesh.normals[i] = -glm::normalize(glm::vec3(0.2F * p.x, 0.2F * p.y - 0.3F, 1));
  }
  const std::uint32_t lamp = test::add_surface(scene, glm::vec3(0), {0.5F, 0.25F, 2});
  test::add_quad(scene, lamp, {-2, 0, 2}, {-2, 0, -2}, {-2, 3, -2}, {-2, 3, 2});
}

void add_all_kinds(LightSet& lights) {
  lights.set_min_distance(0.75F);
  lights.add_omni({1, 0.25F, 0}, {2, 2, 1});
  lights.add_omni({-1, 2, 1}, {0, 3, 3});
  lights.add_oriented({0, 2, 0.5F}, glm::normalize(glm::vec3(0.25F, -1, -0.5F)), {4, 2, 2});
  lights.add_spot({0.5F, 2, 1}, glm::normalize(glm::vec3(0, -1, -2)), {5, 5, 9}, 0.2F, 0.5F);
  lights.add_spot({-1, 1.5F, 0}, {0, -1, 0}, {6, 1, 1}, 0.5F, 0.500001F);
  lights.add_directional(glm::normalize(glm::vec3(-0.5F, -1, -0.75F)), {0.5F, 0.25F, 0.25F});
}

/// Open towards the viewer and the right, so that nothing shadows anything.
Scene corner_scene() {
  Scene scene;
  add_metal_floor(scene);
  add_walls(scene);
  scene.mesh.uv.resize(scene.mesh.positions.size(), glm::vec2(0));
  add_all_kinds(scene.lights);
  scene.camera = {{1, 1.5F, 4}, {-0.25F, 1, 0}, {0.1F, 1, 0}, 60};
  scene.image_size = {120, 90};
  validate(scene);
  return scene;
}

Scene moved(Scene scene, const glm::vec3& by) {
  for (glm::vec3& p : scene.mesh.positions) p += by;
  scene.camera.position += by;
  scene.camera.target += by;
  LightSet lights;
  if (scene.lights.min_distance() > 0) lights.set_min_distance(scene.lights.min_distance());
  for (Light light : scene.lights) {
    if (light.kind != LightKind::directional) light.position += by;
    lights.add(light);
  }
  scene.lights = std::move(lights);
  return scene;
}

class RasterPreviewTest : public ::testing::Test {
protected:
  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }

  OffscreenContext context_;
};

TEST_F(RasterPreviewTest, EqualsTheReferenceInAnOpenCornerWithAllKindsOfLights) {
  const Scene scene = corner_scene();
  const Radiance reference = reference_of(scene);
  EXPECT_LT(difference(preview_of(scene), reference), rounding_error);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    Scene darker = scene;
    darker.lights = without(scene.lights, i);
    EXPECT_GT(difference(preview_of(darker), reference), 1e-3) << "without light " << i;
  }
}

TEST_F(RasterPreviewTest, EqualsTheReferenceInAConvexRoom) {
  for (const char* kind : {"material=diffuse", "material=ggx", "material=ggx&kind=oriented"}) {
    Scene scene = make_builtin(std::string("cloud?lights=200&blocks=0&") + kind);
    scene.image_size = {80, 60};
    const Radiance reference = reference_of(scene);
    EXPECT_LT(difference(preview_of(scene), reference), rounding_error) << kind;
    scene.lights = without(scene.lights, 77);
    EXPECT_GT(difference(preview_of(scene), reference), 3 * rounding_error) << kind;
  }
}

/// A polished floor, seen along itself by a camera as low as the lamp at its other end: one column
/// of pixels, in whose plane both are.
Scene low_lamp_scene(float height) {
  Scene scene;
  const std::uint32_t floor = test::add_surface(scene, glm::vec3(0));
  scene.surfaces[floor].material.lobe = CookTorrance{glm::vec3(0.5F), 0.25F * height};
  test::add_quad(scene, floor, {-2, 0, 3}, {2, 0, 3}, {2, 0, -3}, {-2, 0, -3});
  scene.lights.add_omni({0, height, -4}, glm::vec3(1));
  scene.camera = {{0, height, 4}, {0, 0, 0}, {0, 1, 0}, 2 * height * 57.3F};
  scene.image_size = {1, 200};
  validate(scene);
  return scene;
}

// Where both are in a plane with n, T errs as n.l and n.v do, by 2^-24, and D by 4/alpha times
// that. By way of l + v it would be that over n.l + n.v, which is alpha here.
TEST_F(RasterPreviewTest, KnowsTheHalfVectorWhereLightAndViewerAreOpposite) {
  for (const float height : {0x1p-4F, 0x1p-7F, 0x1p-9F}) {
    const Scene scene = low_lamp_scene(height);
    const double allowed = rounding_error + 0x1p-22 / (0.25 * double(height));
    EXPECT_LT(difference(preview_of(scene), reference_of(scene)), allowed) << height;
  }
}

TEST_F(RasterPreviewTest, EachPartOfTheMaterialCounts) {
  const Scene scene = corner_scene();
  const Radiance picture = preview_of(scene);
  const auto changed = [&](auto change) {
    Scene other = scene;
    change(other);
    return difference(preview_of(other), picture);
  };
  EXPECT_EQ(changed([](Scene&) {}), 0);
  EXPECT_GT(changed([](Scene& s) { s.surfaces[0].texture.reset(); }), 1e-2);
  EXPECT_GT(changed([](Scene& s) { s.surfaces[0].tinted_f0 = {}; }), 1e-3);
  EXPECT_GT(changed([](Scene& s) { s.surfaces[0].texture->wrap.u = Wrap::clamp; }), 1e-2);
  EXPECT_GT(changed([](Scene& s) { s.surfaces[1].material.lobe = NoLobe{}; }), 1e-3);
  EXPECT_GT(changed([](Scene& s) { s.surfaces[2].emission = {}; }), 1e-2);
  EXPECT_GT(changed([](Scene& s) { s.mesh.normals.clear(); }), 1e-3);
}

TEST_F(RasterPreviewTest, SeesBothSidesOfASurface) {
  Scene scene = corner_scene();
  const Radiance reference = reference_of(scene);
  for (glm::uvec3& t : scene.mesh.triangles) std::swap(t.y, t.z);
  EXPECT_LT(difference(preview_of(scene), reference), rounding_error);
}

TEST_F(RasterPreviewTest, IsTheSameFarFromTheOrigin) {
  const Scene scene = corner_scene(); // coordinates are multiples of 1/16
  const Radiance near = preview_of(scene);
  EXPECT_LT(difference(preview_of(moved(scene, {0x1p19F, -0x1p18F, 0x1p17F})), near), 1e-5);
}

TEST_F(RasterPreviewTest, SomeOfTheLightsStandForAll) {
  Scene scene = corner_scene();
  scene.lights = {};
  for (int i = 0; i < 5000; ++i) scene.lights.add_omni({1, 2, 1}, glm::vec3(0.01F));
  RasterPreview preview(scene);
  preview.start(scene.camera, scene.image_size);
  EXPECT_EQ(preview.share(), 0);
  EXPECT_FALSE(preview.advance(0)); // at least one light
  EXPECT_GT(preview.share(), 0);
  EXPECT_LT(preview.share(), 0.1F);
  const Radiance partial = preview.radiance();
  while (!preview.advance(5)) EXPECT_LT(preview.share(), 1);
  EXPECT_EQ(preview.share(), 1);
  EXPECT_LT(difference(partial, preview.radiance()), 1e-5);
}

TEST_F(RasterPreviewTest, LightsComeInAnOrderThatIsNotTheirs) {
  Scene scene = corner_scene();
  scene.lights = {};
  // The first half lights nothing.
  for (int i = 0; i < 4000; ++i) scene.lights.add_omni({1, 2, 1}, glm::vec3(i < 2000 ? 0 : 1));
  RasterPreview preview(scene);
  preview.start(scene.camera, scene.image_size);
  while (preview.share() < 0.2F) preview.advance(0);
  const Radiance partial = preview.radiance();
  preview.advance(long_enough);
  EXPECT_LT(difference(partial, preview.radiance()), 0.2);
}

TEST_F(RasterPreviewTest, WithoutLightsOnlyEmissionIsSeen) {
  Scene scene = corner_scene();
  scene.lights = {};
  RasterPreview preview(scene);
  EXPECT_TRUE(preview.radiance().empty());
  preview.start(scene.camera, scene.image_size);
  EXPECT_EQ(preview.share(), 1);
  EXPECT_TRUE(preview.advance(1));
  const Radiance picture = preview.radiance();
  EXPECT_LT(difference(picture, reference_of(scene)), 1e-6);
  EXPECT_THAT(picture, testing::Contains(glm::vec3(0.5F, 0.25F, 2)));
}

TEST_F(RasterPreviewTest, NothingSeenIsBlack) {
  Scene scene = corner_scene();
  scene.camera.target = {1, 1.5F, 8};
  EXPECT_THAT(preview_of(scene), Each(glm::vec3(0)));
}

TEST_F(RasterPreviewTest, PictureCanBeginAgainInAnotherSizeAndFromElsewhere) {
  Scene scene = corner_scene();
  RasterPreview preview(scene);
  for (const glm::uvec2 size : {glm::uvec2(64, 48), glm::uvec2(1, 1), glm::uvec2(30, 70)}) {
    scene.image_size = size;
    scene.camera.position.x -= 0.25F;
    preview.start(scene.camera, size);
    preview.advance(0); // stopped half-way, and begun again
    preview.start(scene.camera, size);
    EXPECT_TRUE(preview.advance(long_enough));
    EXPECT_EQ(preview.size(), size);
    EXPECT_LT(difference(preview.radiance(), reference_of(scene)), rounding_error) << size.x;
  }
  EXPECT_THROW(preview.start({.target = {0, 0, 1}}, {4, 4}), InputError);
  EXPECT_THROW(preview.start(scene.camera, {0, 4}), InputError);
}

TEST_F(RasterPreviewTest, BudgetIsKeptWithAMillionLights) {
  Scene scene = make_builtin("cloud?lights=1000000&blocks=0");
  RasterPreview preview(scene);
  preview.start(scene.camera, {64, 48});
  preview.advance(1); // the driver compiles on first use
  const auto begin = Clock::now();
  EXPECT_FALSE(preview.advance(30));
  EXPECT_LT(seconds_since(begin), 2);
}

TEST_F(RasterPreviewTest, LightInTheSurfaceIsNoNaN) {
  Scene scene = corner_scene();
  scene.lights = {};
  scene.lights.add_omni({0, 0, 0}, glm::vec3(1));
  scene.lights.add_oriented(scene.camera.position, {0, 0, -1}, glm::vec3(1));
  for (const glm::vec3& c : preview_of(scene))
    EXPECT_TRUE(std::isfinite(luminance(c)) && luminance(c) >= 0);
}

TEST(PreviewMaterialTest, OtherLobesBecomeCookTorrance) {
  const PreviewMaterial phong = preview_material({glm::vec3(0.5F), Phong{{0.3F, 2, 0}, 48}});
  EXPECT_EQ(phong.diffuse, glm::vec3(0.5F));
  EXPECT_EQ(phong.f0, glm::vec3(0.3F, 1, 0));
  EXPECT_FLOAT_EQ(phong.alpha, 0.2F);
  EXPECT_FLOAT_EQ(preview_material({{}, Phong{{}, 0}}).alpha, 1);
  EXPECT_FLOAT_EQ(preview_material({{}, Ward{glm::vec3(0.1F), 0.15F}}).alpha, 0.15F);
  EXPECT_EQ(preview_material({glm::vec3(1), NoLobe{}}).alpha, 0);
}

} // namespace
} // namespace lightcuts::viz
