// SPDX-License-Identifier: MIT
#include <lightcuts/render/builtin/builtin_scenes.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/scene/bounds.h>

#include <tests/render/support/refusal.h>

namespace lightcuts {
namespace {

glm::dvec3 corner(const Scene& scene, std::size_t triangle, int i) {
  return scene.mesh.positions[scene.mesh.triangles[triangle][i]];
}

glm::dvec3 face_normal(const Scene& scene, std::size_t t) {
  return glm::cross(corner(scene, t, 1) - corner(scene, t, 0),
                    corner(scene, t, 2) - corner(scene, t, 0));
}

glm::dvec3 total_intensity(const Scene& scene) {
  glm::dvec3 sum{0};
  for (const Light& light : scene.lights) sum += glm::dvec3(light.intensity);
  return sum;
}

bool has_glossy_surface(const Scene& scene) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                     [](const Surface& s) { return s.material.is_glossy(); });
}

TEST(BuiltinScenes, are_all_listed_with_a_description) {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) {
    names.push_back(scene.name);
    EXPECT_FALSE(scene.description.empty());
    EXPECT_TRUE(is_builtin(scene.name));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"desk", "desk-red", "bedroom", "cloud"}));
  EXPECT_TRUE(is_builtin("cloud?lights=3"));
  EXPECT_FALSE(is_builtin("clouds"));
  EXPECT_FALSE(is_builtin("./cloud"));
  EXPECT_FALSE(is_builtin(""));
}

TEST(BuiltinScenes, are_valid_lit_and_named) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene scene = make_builtin(builtin.name);
    EXPECT_NO_THROW(validate(scene)) << builtin.name;
    EXPECT_EQ(scene.name, builtin.name);
    EXPECT_FALSE(scene.lights.empty());
    EXPECT_EQ(scene.image_size, glm::uvec2(640, 480));
    EXPECT_TRUE(scene.notes.empty());
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t)
      EXPECT_GT(glm::length(face_normal(scene, t)), 0) << builtin.name << ' ' << t;
  }
}

TEST(BuiltinScenes, use_every_surface) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene scene = make_builtin(builtin.name);
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
      EXPECT_GT(std::count(scene.mesh.surface.begin(), scene.mesh.surface.end(), s), 0)
          << builtin.name << ": " << scene.surfaces[s].name;
  }
}

TEST(BuiltinScenes, conserve_energy) {
  for (const BuiltinScene& builtin : builtin_scenes())
    for (const Surface& s : make_builtin(builtin.name).surfaces)
      for (int c = 0; c < 3; ++c) {
        const auto* phong = std::get_if<Phong>(&s.material.lobe);
        EXPECT_LE(s.material.diffuse[c] + (phong ? phong->reflectance[c] : 0), 1) << s.name;
      }
}

TEST(BuiltinScenes, have_smooth_normals_on_the_side_of_their_faces) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene scene = make_builtin(builtin.name);
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3 normal = scene.mesh.normals[scene.mesh.triangles[t][i]];
        if (normal == glm::dvec3(0)) continue;
        EXPECT_GT(glm::dot(normal, face_normal(scene, t)), 0)
            << builtin.name << ": " << scene.surfaces[scene.mesh.surface[t]].name;
      }
  }
}

TEST(BuiltinScenes, have_their_lights_inside_the_scene) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene scene = make_builtin(builtin.name);
    const Box box = scene_bounds(scene.mesh);
    for (const Light& light : scene.lights) EXPECT_TRUE(box.contains(light.position));
  }
}

TEST(BuiltinScenes, refuse_unknown_names_and_parameters) {
  expect_refusal("unknown built-in scene 'foo'; known: desk, desk-red, bedroom, cloud",
                 [] { (void)make_builtin("foo"); });
  expect_refusal("desk: parameter 'lights' is unknown",
                 [] { (void)make_builtin("desk?lights=3"); });
  expect_refusal("desk-red: parameter 'x' is unknown", [] { (void)make_builtin("desk-red?x=1"); });
  expect_refusal("bedroom: parameter 'seed' is unknown",
                 [] { (void)make_builtin("bedroom?seed=3"); });
  expect_refusal(
      "cloud: parameter 'light' is unknown; known: lights, blocks, material, kind, clamp, seed",
      [] { (void)make_builtin("cloud?light=3"); });
}

TEST(BuiltinScenes, refuse_bad_values) {
  const auto refuses = [](const std::string& spec, const std::string& part) {
    expect_refusal(part, [&] { (void)make_builtin(spec); });
  };
  refuses("cloud?lights=0", "cloud: parameter 'lights' is 0, expected 1 to");
  refuses("cloud?lights=many", "cloud: parameter 'lights' is 'many', expected a whole number");
  refuses("cloud?lights=-1", "'-1', expected a whole number");
  refuses("cloud?lights=1.5", "'1.5', expected a whole number");
  refuses("cloud?lights=", "'', expected a whole number");
  refuses("cloud?lights=99999999999999999999999", "expected 1 to");
  refuses("cloud?lights", "cloud: parameter 'lights' has no value");
  refuses("cloud?lights=3&&seed=1", "parameter '' has no value");
  refuses("cloud?seed=1&seed=2", "cloud: parameter 'seed' is given twice");
  refuses("cloud?blocks=100001", "cloud: parameter 'blocks' is 100001, expected 0 to 100000");
  for (const char* clamp : {"0", "-1", "inf", "nan", "1m", ""})
    refuses(std::string("cloud?clamp=") + clamp,
            "cloud: parameter 'clamp' is '" + std::string(clamp) + "', expected a number above 0");
  refuses("cloud?kind=laser",
          "'laser', expected one of omni, oriented, spot, directional, profile, mixed");
  refuses("cloud?material=metal", "'metal', expected one of diffuse, phong, ward, ggx, glossy");
}

TEST(DeskScene, has_a_light_a_centimetre_in_front_of_each_cell_of_the_screen) {
  const Scene scene = make_builtin("desk");
  ASSERT_EQ(scene.lights.size(), 24U * 9U);
  EXPECT_TRUE(has_glossy_surface(scene));
  std::size_t cells = 0;
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    if (scene.surfaces[scene.mesh.surface[t]].name != "screen") continue;
    const double gap = double(scene.lights[0].position.z) - corner(scene, t, 0).z;
    EXPECT_NEAR(gap, 0.01, 1e-6);
    EXPECT_GT(face_normal(scene, t).z, 0);
    ++cells;
  }
  EXPECT_EQ(cells, 2U * 24U * 9U);
  for (const Light& light : scene.lights) {
    EXPECT_EQ(light.position.z, scene.lights[0].position.z);
    EXPECT_EQ(light.intensity, scene.lights[0].intensity);
  }
}

TEST(DeskScene, has_a_red_diagonal_where_asked) {
  const Scene desk = make_builtin("desk"), red_desk = make_builtin("desk-red");
  ASSERT_EQ(red_desk.lights.size(), desk.lights.size());
  int reds = 0;
  for (std::size_t i = 0; i < red_desk.lights.size(); ++i) {
    EXPECT_EQ(red_desk.lights[i].position, desk.lights[i].position);
    EXPECT_EQ(red_desk.lights[i].intensity.r, desk.lights[i].intensity.r);
    const bool is_red = red_desk.lights[i].intensity.g == 0 && red_desk.lights[i].intensity.b == 0;
    EXPECT_TRUE(is_red || red_desk.lights[i].intensity == desk.lights[i].intensity);
    reds += is_red;
  }
  EXPECT_EQ(reds, 24); // one per column
  EXPECT_EQ(red_desk.lights[0].intensity.g, 0);
  EXPECT_EQ(red_desk.lights[215].intensity.g, 0);
}

TEST(BedroomScene, is_furnished_and_lit_by_100_coloured_lights) {
  const Scene scene = make_builtin("bedroom");
  EXPECT_GE(scene.mesh.triangles.size(), 500U);
  EXPECT_LE(scene.mesh.triangles.size(), 3000U);
  EXPECT_EQ(scene.lights.size(), 100U);
  EXPECT_TRUE(has_glossy_surface(scene));
  for (const Light& light : scene.lights) EXPECT_NE(light.intensity.r, light.intensity.g);
}

TEST(BedroomScene, has_no_furniture_where_the_lights_are) {
  const Scene scene = make_builtin("bedroom");
  Box lights = Box::empty();
  for (const Light& light : scene.lights) lights.extend(light.position);
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    Box triangle = Box::empty();
    for (int i = 0; i < 3; ++i) triangle.extend(glm::vec3(corner(scene, t, i)));
    const bool overlap = glm::all(glm::lessThanEqual(triangle.lo, lights.hi)) &&
                         glm::all(glm::lessThanEqual(lights.lo, triangle.hi));
    EXPECT_FALSE(overlap) << scene.surfaces[scene.mesh.surface[t]].name;
  }
}

TEST(CloudScene, obeys_its_parameters) {
  EXPECT_EQ(make_builtin("cloud").lights.size(), 10000U);
  EXPECT_EQ(make_builtin("cloud").mesh.triangles.size(), 12U + 40 * 10);
  const Scene scene = make_builtin("cloud?lights=123&blocks=7&material=diffuse");
  EXPECT_EQ(scene.lights.size(), 123U);
  EXPECT_EQ(scene.mesh.triangles.size(), 12U + 7 * 10);
  EXPECT_FALSE(has_glossy_surface(scene));
  EXPECT_TRUE(has_glossy_surface(make_builtin("cloud?material=glossy")));
  EXPECT_EQ(make_builtin("cloud?").lights.size(), 10000U);
}

TEST(CloudScene, has_lights_of_the_kind_asked_for_clamped_where_asked) {
  const auto kinds = [](const std::string& kind) {
    std::set<LightKind> found;
    for (const Light& light : make_builtin("cloud?lights=40&kind=" + kind).lights)
      found.insert(light.kind);
    return found;
  };
  EXPECT_EQ(kinds("omni"), std::set{LightKind::omni});
  EXPECT_EQ(kinds("oriented"), std::set{LightKind::oriented});
  EXPECT_EQ(kinds("spot"), std::set{LightKind::spot});
  EXPECT_EQ(kinds("directional"), std::set{LightKind::directional});
  EXPECT_EQ(kinds("profile"), std::set{LightKind::profile});
  EXPECT_EQ(kinds("mixed").size(), 5U);
  EXPECT_EQ(make_builtin("cloud?clamp=0.25").lights.min_distance(), 0.25F);
  EXPECT_EQ(make_builtin("cloud").lights.min_distance(), 0);
}

TEST(CloudScene, changes_with_its_seed_only) {
  const Scene one = make_builtin("cloud?seed=1"), again = make_builtin("cloud"),
              two = make_builtin("cloud?seed=2");
  EXPECT_EQ(one.mesh.positions, again.mesh.positions);
  EXPECT_EQ(one.lights[5].position, again.lights[5].position);
  EXPECT_NE(one.mesh.positions, two.mesh.positions);
  EXPECT_NE(one.lights[5].position, two.lights[5].position);
}

TEST(CloudScene, has_a_total_intensity_that_does_not_depend_on_the_number_of_lights) {
  const glm::dvec3 few = total_intensity(make_builtin("cloud?lights=10"));
  const glm::dvec3 many = total_intensity(make_builtin("cloud?lights=5000"));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(few[c] / many[c], 1, 1e-6);
}

TEST(CloudScene, keeps_blocks_inside_the_room_and_lights_above_them) {
  const Scene scene = make_builtin("cloud?blocks=500");
  const Box room = scene_bounds(make_builtin("cloud?blocks=0").mesh);
  EXPECT_EQ(scene_bounds(scene.mesh), room);
  float top = 0;
  for (std::size_t t = 12; t < scene.mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) top = std::max(top, float(corner(scene, t, i).y));
  EXPECT_LT(top, scene.camera.position.y);
  for (const Light& light : scene.lights) EXPECT_GT(light.position.y, top);
}

TEST(CloudScene, is_strictly_convex_without_blocks) {
  const Scene scene = make_builtin("cloud?blocks=0");
  ASSERT_EQ(scene.mesh.triangles.size(), 12U);
  const auto inside = [&](const glm::dvec3& p) {
    for (std::size_t t = 0; t < 12; ++t)
      if (!(glm::dot(face_normal(scene, t), p - corner(scene, t, 0)) > 0)) return false;
    return true;
  };
  EXPECT_TRUE(inside(scene.camera.position)); // the walls look inwards
  for (const Light& light : scene.lights) EXPECT_TRUE(inside(light.position));
}

TEST(CloudScene, has_blocks_that_look_outwards) {
  const Scene scene = make_builtin("cloud?blocks=30");
  for (std::size_t block = 0; block < 30; ++block) {
    glm::dvec3 centre{0};
    for (std::size_t t = 0; t < 10; ++t)
      for (int i = 0; i < 3; ++i) centre += corner(scene, 12 + 10 * block + t, i) / 30.0;
    for (std::size_t t = 0; t < 10; ++t) {
      const std::size_t face = 12 + 10 * block + t;
      EXPECT_GT(glm::dot(face_normal(scene, face), corner(scene, face, 0) - centre), 0);
    }
  }
}

} // namespace
} // namespace lightcuts
