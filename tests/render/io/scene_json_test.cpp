// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/scene_json.h>

#include <algorithm>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/lighting/environment/environment_lights.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/shapes/shape_lights.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>
#include <nlohmann/json.hpp>

#include <tests/render/support/box_scene.h>
#include <tests/render/support/gltf_file.h>
#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

class SceneJson : public testing::Test {
protected:
  SceneJson() {
    write(folder_.path / "room.obj", "v 0 0 0\nv 4 0 0\nv 4 2 4\nf 1 2 3\n");
    write(folder_.path / "lamp.gltf", test::gltf().dump());
  }

  Scene load(const std::string& text) {
    write(folder_.path / "scene.json", text);
    return load_scene_json(folder_.path / "scene.json");
  }

  /// A scene that has `members` beside its geometry.
  Scene load_with(const std::string& members) {
    return load(R"({"geometry": "room.obj", )" + members + "}");
  }

  void refuses_text(const std::string& text, const std::string& part) {
    expect_refusal("scene.json: " + part, [&] { (void)load(text); });
  }
  void refuses(const std::string& members, const std::string& part) {
    refuses_text(R"({"geometry": "room.obj", )" + members + "}", part);
  }

  TemporaryFolder folder_;
};

TEST_F(SceneJson, reads_every_member) {
  const Scene scene = load(R"({"geometry": "room.obj",
    "camera": {"position": [1, 2, 3], "target": [4, 5, 7], "up": [0, 0, 1], "fov": 30.5},
    "image": {"width": 320, "height": 200},
    "lights": [{"position": [1, 2, 3], "intensity": [4, 5, 6]},
               {"position": [7.5, 0, -1], "intensity": 2}]})");
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.mesh.triangles.size(), 1U);
  EXPECT_EQ(scene.camera.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.camera.target, glm::vec3(4, 5, 7));
  EXPECT_EQ(scene.camera.up, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene.camera.vertical_fov, 30.5F);
  EXPECT_EQ(scene.image_size, glm::uvec2(320, 200));
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.lights[0].intensity, glm::vec3(4, 5, 6));
  EXPECT_EQ(scene.lights[1].intensity, glm::vec3(2));
}

TEST_F(SceneJson, needs_a_geometry_only) {
  const Scene scene = load(R"({"geometry": "room.obj"})");
  EXPECT_NO_THROW(validate(scene));
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.image_size, glm::uvec2(640, 480));
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_NE(scene.notes[0].find("scene.json: no camera: framed"), std::string::npos);
}

TEST_F(SceneJson, joins_several_models) {
  const Scene scene = load(R"({"geometry": ["room.obj", "lamp.gltf", "room.obj"]})");
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(scene.mesh.triangles.size(), 3U);
  EXPECT_EQ(scene.lights.size(), 4U);
  EXPECT_EQ(scene.camera.position, glm::vec3(1, 2, 8)); // the model's
}

TEST_F(SceneJson, prefers_its_own_camera_and_lights_to_the_models) {
  const Scene scene = load(R"({"geometry": "lamp.gltf",
    "camera": {"position": [0, 0, 9], "target": [0, 0, 0]}, "lights": []})");
  EXPECT_EQ(scene.camera.position, glm::vec3(0, 0, 9));
  EXPECT_TRUE(scene.lights.empty());
}

TEST_F(SceneJson, generates_a_cloud) {
  const Scene scene = load_with(
      R"("lights": {"count": 50, "seed": 9,
                    "box": [[1, 2, 3], [1, 5, 4]], "intensity": [6, 0, 2]})");
  LightSet expected;
  generate({50, 9, {1, 2, 3}, {1, 5, 4}, {6, 0, 2}, false}, expected);
  ASSERT_EQ(scene.lights.size(), 50U);
  EXPECT_EQ(scene.lights[49].position, expected[49].position);
  EXPECT_EQ(scene.lights[49].intensity, expected[49].intensity);
}

TEST_F(SceneJson, generates_the_default_cloud) {
  const Scene scene = load_with(R"("lights": {"count": 50})");
  LightSet expected;
  generate(default_cloud(scene.mesh, 50, 1), expected);
  ASSERT_EQ(scene.lights.size(), 50U);
  EXPECT_EQ(scene.lights[49].position, expected[49].position);
  EXPECT_EQ(scene.lights[49].intensity, expected[49].intensity);
}

TEST_F(SceneJson, reads_lights_of_every_kind) {
  const Scene scene = load_with(R"("min_distance": 0.125, "lights": [
    {"type": "omni", "position": [1, 2, 3], "intensity": 4},
    {"type": "oriented", "position": [1, 2, 3], "normal": [0, -2, 0], "intensity": [4, 5, 6]},
    {"type": "spot", "position": [1, 2, 3], "axis": [0, 0, 5], "intensity": 7,
     "inner": 60, "outer": 90},
    {"type": "spot", "position": [1, 2, 3], "axis": [0, 0, 5], "intensity": 7, "outer": 180},
    {"type": "directional", "direction": [0, -3, 4], "irradiance": [1, 2, 3]}])");
  LightSet expected;
  expected.add_omni({1, 2, 3}, glm::vec3(4));
  expected.add_oriented({1, 2, 3}, {0, -1, 0}, {4, 5, 6});
  constexpr float pi = 3.14159265358979F;
  expected.add_spot({1, 2, 3}, {0, 0, 1}, glm::vec3(7), pi / 3, pi / 2);
  expected.add_spot({1, 2, 3}, {0, 0, 1}, glm::vec3(7), 0, pi);
  expected.add_directional({0, -0.6F, 0.8F}, {1, 2, 3});
  ASSERT_TRUE(test::same_bits(scene.lights, expected));
  for (int i = 0; i < 5; ++i) {
    EXPECT_FLOAT_EQ(scene.lights[i].cos_inner, expected[i].cos_inner);
    EXPECT_NEAR(scene.lights[i].cos_outer, expected[i].cos_outer, 1e-7);
  }
  EXPECT_EQ(scene.lights.min_distance(), 0.125F);
}

TEST_F(SceneJson, generates_lights_of_every_kind_in_the_order_given) {
  write(folder_.path / "lamp.mtl", "newmtl lamp\nKd 0.5 0.5 0.5\nKe 1 2 3\n");
  write(folder_.path / "lit.obj",
        "mtllib lamp.mtl\nusemtl lamp\nv 0 0 0\nv 4 0 0\nv 4 2 4\nf 1 2 3\n"
        "v 0 1 0\nv 4 1 0\nv 4 3 4\nf 4 5 6\n");
  Film sky({4, 2});
  for (const char* channel : {"R", "G", "B"}) std::ranges::fill(sky.channel(channel), 1.0F);
  write_exr(sky, folder_.path / "sky.exr");
  const Scene scene = load(R"({"geometry": "lit.obj", "lights": [
    {"position": [1, 5, 1], "intensity": 4},
    {"generate": "cloud", "count": 3},
    {"generate": "area", "count": 4, "seed": 5},
    {"generate": "environment", "file": "sky.exr", "count": 6, "turn": 90, "visible": true},
    {"generate": "rectangle", "position": [1, 4, 1], "normal": [0, -2, 0], "along": [0, 0, 1],
     "width": 2, "height": 0.5, "radiance": [1, 2, 3], "count": 5, "seed": 3},
    {"generate": "disc", "position": [1, 4, 1], "normal": [0, -1, 0], "radius": 0.5, "power": 10},
    {"generate": "sphere", "position": [1, 4, 1], "radius": 0.5, "radiance": 2, "count": 7},
    {"generate": "tube", "position": [1, 4, 1], "axis": [1, 0, 0], "radius": 0.1, "length": 2,
     "radiance": 2, "count": 7},
    {"generate": "vpl", "paths": 7, "bounces": 1, "seed": 8},
    {"generate": "surfels", "count": 9, "seed": 10}]})");
  Scene expected = load(R"({"geometry": "lit.obj"})");
  expected.lights.add_omni({1, 5, 1}, glm::vec3(4));
  generate(default_cloud(expected.mesh, 3, 1), expected.lights);
  add_area_lights(expected, {.count = 4, .seed = 5});
  add_environment_lights(expected, read_environment(folder_.path / "sky.exr"),
                         {.turn = 90, .visible = true, .count = 6});
  add_shape_lights(expected, {.kind = ShapeKind::rectangle,
                              .centre = {1, 4, 1},
                              .axis = {0, -1, 0},
                              .along = {0, 0, 1},
                              .sides = {2, 0.5F},
                              .radiance = {1, 2, 3},
                              .count = 5,
                              .seed = 3});
  ShapeLights disc{.kind = ShapeKind::disc, .centre = {1, 4, 1}, .radius = 0.5F};
  disc.radiance = glm::vec3(float(10 / (std::numbers::pi * area_of(disc))));
  add_shape_lights(expected, disc);
  add_shape_lights(expected, {.kind = ShapeKind::sphere,
                              .centre = {1, 4, 1},
                              .radius = 0.5F,
                              .radiance = glm::vec3(2),
                              .count = 7});
  add_shape_lights(expected, {.kind = ShapeKind::tube,
                              .centre = {1, 4, 1},
                              .axis = {1, 0, 0},
                              .radius = 0.1F,
                              .length = 2,
                              .radiance = glm::vec3(2),
                              .count = 7});
  add_virtual_point_lights(expected, {.paths = 7, .bounces = 1, .seed = 8});
  add_surfels(expected, {.count = 9, .seed = 10});
  EXPECT_EQ(scene.backdrops.size(), 1U);
  EXPECT_GT(scene.lights.size(), 1U + 3 + 4 + 6 + 5 + 64 + 7 + 7 + 9);
  EXPECT_TRUE(test::same_bits(scene.lights, expected.lights));
  EXPECT_EQ(scene.notes, expected.notes);
}

TEST_F(SceneJson, refuses_bad_lights_naming_the_element) {
  const auto light = [&](const std::string& text, const std::string& part) {
    refuses(R"("lights": [{"position": [0, 1, 0], "intensity": 1}, {)" + text + "}]",
            "/lights/1" + part);
  };
  light(R"("type": "point")",
        "/type is 'point', expected one of omni, oriented, spot, directional, profile");
  light(R"("type": 5)", "/type is a number, expected a string");
  light(R"("type": "oriented", "position": [0, 0, 0], "intensity": 1)", "/normal is missing");
  light(R"("type": "oriented", "position": [0, 0, 0], "intensity": 1, "normal": [0, 0, 0])",
        "/normal is zero, expected a direction");
  light(R"("type": "omni", "position": [0, 0, 0], "intensity": 1, "axis": [0, 0, 1])",
        "/axis is unknown; known: type, position, intensity");
  light(R"("type": "directional", "direction": [0, 1, 0], "intensity": 1)",
        "/intensity is unknown; known: type, direction, irradiance");
  light(R"("type": "directional", "direction": [0, 1, 0], "irradiance": [1, 2, -1])",
        "/irradiance/2 is negative");
  const auto spot = [&](const std::string& angles, const std::string& part) {
    light(R"("type": "spot", "position": [0, 0, 0], "intensity": 1, "axis": [0, 1, 0], )" + angles,
          part);
  };
  spot(R"("outer": 0)", "/outer is 0, expected more than 0 and at most 180 degrees");
  spot(R"("outer": 180.5)", "/outer is 180.5, expected");
  spot(R"("inner": 20)", "/outer is missing");
  spot(R"("outer": 20, "inner": 20)", "/inner is 20, expected less than outer, 20");
  spot(R"("outer": 20, "inner": -1)", "/inner is negative");
}

TEST_F(SceneJson, refuses_bad_generators_naming_the_element) {
  const auto generator = [&](const std::string& text, const std::string& part) {
    refuses(R"("lights": [{"generate": )" + text + "}]", "/lights/0" + part);
  };
  generator(R"("sun")",
            "/generate is 'sun', expected 'cloud', 'area', 'environment', 'vpl', 'surfels', "
            "'rectangle', 'disc', 'sphere' or 'tube'");
  generator("1", "/generate is a number, expected a string");
  generator(R"("cloud", "paths": 1)", "/paths is unknown; known: generate, count");
  generator(R"("area")", "/count is missing");
  generator(R"("area", "count": 0)", "/count is 0, expected a whole number from 1 to 100000000");
  generator(R"("area", "count": 5)", ": area lights: no surface emits light");
  generator(R"("environment", "count": 5)", "/file is missing");
  generator(R"("environment", "file": "absent.exr")", ": ");
  expect_refusal("absent.exr", [&] {
    (void)load_with(R"("lights": [{"generate": "environment", "file": "absent.exr"}])");
  });
  generator(R"("environment", "file": "a.exr", "count": 0)", "/count is 0, expected");
  generator(R"("environment", "file": "a.exr", "turn": "east")", "/turn is a string, expected");
  generator(R"("environment", "file": "a.exr", "visible": 1)", "/visible is a number, expected");
  const std::string ball = R"("sphere", "position": [0, 1, 0], )";
  generator(ball + R"("radius": 1)", " needs either radiance or power");
  generator(ball + R"("radius": 1, "power": 1, "radiance": 1)", " needs either radiance or power");
  generator(ball + R"("radius": 0, "power": 1)", "/radius is 0, expected more than 0");
  generator(ball + R"("radius": 1, "power": 1, "length": 1)", "/length is unknown; known: ");
  generator(ball + R"("radius": 1, "power": -1)", "/power is negative");
  generator(R"("rectangle", "position": [0, 1, 0], "normal": [0, 1, 0], "along": [0, 2, 0],
               "width": 1, "height": 1, "radiance": 1)",
            ": rectangle light: along is parallel to the normal");
  generator(R"("vpl", "count": 5)", "/count is unknown; known: generate, paths, bounces, seed");
  generator(R"("vpl", "paths": -5)", "/paths is -5, expected");
  generator(R"("vpl", "paths": 5, "bounces": 1001)", "/bounces is 1001, expected");
  generator(R"("vpl", "paths": 5)", ": VPLs: no light to start from");
  generator(R"("surfels", "count": 5, "seed": -1)", "/seed is -1, expected");
  generator(R"("surfels", "count": 5)", ": surfels: no light to reflect");
}

TEST_F(SceneJson, names_groups_of_lights_and_of_what_is_generated) {
  const Scene scene = load_with(R"("lights": [
    {"group": "sun", "type": "directional", "direction": [0, -1, 0], "irradiance": 1},
    {"position": [1, 1, 1], "intensity": 1},
    {"group": "lamps", "position": [1, 1, 1], "intensity": 1},
    {"group": "lamps", "generate": "cloud", "count": 5},
    {"group": "sun", "generate": "vpl", "paths": 3, "bounces": 1}])");
  ASSERT_EQ(scene.groups.size(), 3U);
  EXPECT_EQ(scene.groups[0], (LightGroup{"sun", 0, 1}));
  EXPECT_EQ(scene.groups[1], (LightGroup{"lamps", 2, 6}));
  EXPECT_EQ(scene.groups[2], (LightGroup{"sun", 8, scene.lights.size() - 8}));
  EXPECT_TRUE(load_with(R"("lights": [{"position": [1, 1, 1], "intensity": 1}])").groups.empty());
}

TEST_F(SceneJson, refuses_names_that_no_channel_can_have) {
  const auto group = [&](const std::string& name, const std::string& part) {
    refuses(R"("lights": [{"position": [0, 1, 0], "intensity": 1, "group": )" + name + "}]",
            "/lights/0/group" + part);
  };
  group("5", " is a number, expected a string");
  for (const char* name : {R"("")", R"("a.b")", R"("é")", R"("a/b")"})
    group(name, " is not a name of up to 64 letters, digits, '-', '_' and blanks");
  group("\"" + std::string(65, 'a') + "\"", " is not a name");
  group(R"("others")", " is 'others', which is what has no group");
}

TEST_F(SceneJson, refuses_bad_distances) {
  refuses(R"("min_distance": 0)", "/min_distance is 0, expected more than 0");
  refuses(R"("min_distance": -1)", "/min_distance is -1, expected more than 0");
  refuses(R"("min_distance": "1")", "/min_distance is a string, expected a number");
}

TEST_F(SceneJson, refuses_malformed_json_with_line_and_column) {
  refuses_text("{\n  \"geometry\": \"room.obj\",\n  \"image\": }", "line 3, column 12: ");
  refuses_text("{\"geometry\"", "line 1, column 12: ");
  refuses_text("", "line 1, column 1: ");
  refuses_text("{} x", "line 1, column 4: ");
}

TEST_F(SceneJson, refuses_wrong_types_naming_the_element) {
  const std::string p = R"("lights": [{"position": [0, "1", 0], "intensity": 1}])";
  refuses(p, "/lights/0/position/1 is a string, expected a number");
  refuses(R"("lights": [{"position": [0, 1], "intensity": 1}])",
          "/lights/0/position has 2 elements, expected three");
  refuses(R"("lights": [{"position": 7, "intensity": 1}])",
          "/lights/0/position is a number, expected a list of three numbers");
  refuses(R"("lights": [{"position": [0, 1, 2], "intensity": null}])",
          "/lights/0/intensity is null, expected a list of three numbers");
  refuses(R"("lights": [[]])", "/lights/0 is an array, expected an object");
  refuses(R"("lights": 5)", "/lights is a number, expected an object");
  refuses(R"("camera": [])", "/camera is an array, expected an object");
  refuses(R"("image": {"width": "4", "height": 3})",
          "/image/width is a string, expected a whole number");
  refuses_text(R"({"geometry": 5})", "/geometry is a number, expected a string");
  refuses_text(R"({"geometry": ["room.obj", 5]})", "/geometry/1 is a number, expected a string");
  refuses_text("[]", "the whole is an array, expected an object");
}

TEST_F(SceneJson, refuses_missing_and_unknown_members) {
  refuses_text("{}", "/geometry is missing");
  refuses_text(R"({"geometry": []})", "/geometry is empty");
  refuses(R"("lamps": 5)",
          "/lamps is unknown; known: geometry, camera, image, lights, min_distance");
  refuses(R"("camera": {"position": [0, 0, 1], "target": [0, 0, 0], "fovy": 4})",
          "/camera/fovy is unknown; known: position, target, up, fov");
  refuses(R"("camera": {"position": [0, 0, 1]})", "/camera/target is missing");
  refuses(R"("image": {"width": 5})", "/image/height is missing");
  refuses(R"("image": {"width": 5, "height": 5, "depth": 5})", "/image/depth is unknown");
  refuses(R"("lights": [{"position": [0, 0, 0]}])", "/lights/0/intensity is missing");
  refuses(R"("lights": [{"position": [0, 0, 0], "intensity": 1, "color": 2}])",
          "/lights/0/color is unknown; known: type, position, intensity");
  refuses(R"("lights": {"seed": 1})", "/lights/count is missing");
  refuses(R"("lights": {"count": 1, "number": 2})", "/lights/number is unknown");
}

TEST_F(SceneJson, refuses_numbers_out_of_range) {
  refuses(R"("lights": [{"position": [0, 1e39, 0], "intensity": 1}])",
          "/lights/0/position/1 is 1e+39, out of range");
  refuses(R"("lights": [{"position": [0, 1e999, 0], "intensity": 1}])", "number overflow");
  refuses(R"("lights": [{"position": [0, 1, 0], "intensity": [1, -2, 1]}])",
          "/lights/0/intensity/1 is negative");
  refuses(R"("lights": [{"position": [0, 1, 0], "intensity": -1}])",
          "/lights/0/intensity is negative");
  refuses(R"("lights": {"count": 5, "intensity": [1, 1, -1]})", "/lights/intensity/2 is negative");
}

TEST_F(SceneJson, refuses_counts_and_seeds_that_are_not_whole_numbers_in_range) {
  for (const std::string count : {"0", "-1", "1.5", "100000001", "1e3"})
    refuses(R"("lights": {"count": )" + count + "}",
            "/lights/count is " + (count == "1e3" ? "1000.0" : count) +
                ", expected a whole number from 1 to 100000000");
  refuses(R"("lights": {"count": 5, "seed": -1})", "/lights/seed is -1");
  refuses(R"("lights": {"count": 5, "seed": 99999999999999999999})", "/lights/seed is");
}

TEST_F(SceneJson, refuses_bad_boxes) {
  refuses(R"("lights": {"count": 5, "box": [[0, 3, 0], [1, 2, 1]]})",
          "/lights/box/0 exceeds the other corner in y");
  refuses(R"("lights": {"count": 5, "box": [[0, 3, 0]]})",
          "/lights/box is not a list of two corners");
  refuses(R"("lights": {"count": 5, "box": 3})", "/lights/box is not a list of two corners");
}

TEST_F(SceneJson, refuses_bad_image_sizes) {
  refuses(R"("image": {"width": 0, "height": 5})",
          "/image/width is 0, expected a whole number from 1 to 16384");
  refuses(R"("image": {"width": 5, "height": 16385})", "/image/height is 16385, expected");
  refuses(R"("image": {"width": 5.5, "height": 5})", "/image/width is 5.5, expected");
  EXPECT_NO_THROW((void)load_with(R"("image": {"width": 16384, "height": 1})"));
}

TEST_F(SceneJson, refuses_bad_cameras) {
  const auto camera = [&](const std::string& text, const std::string& part) {
    refuses(R"("camera": {"target": [0, 0, 0], )" + text + "}", part);
  };
  camera(R"("position": [0, 0, 1], "fov": 0)", "/camera/fov is 0, expected more than 0");
  camera(R"("position": [0, 0, 1], "fov": 180)", "/camera/fov is 180, expected");
  camera(R"("position": [0, 0, 1], "fov": -45)", "/camera/fov is -45, expected");
  camera(R"("position": [0, 0, 0])", "/camera/position equals target");
  camera(R"("position": [0, 5, 0])", "/camera/up is parallel to the view");
  camera(R"("position": [0, 0, 1], "up": [0, 0, -3])", "/camera/up is parallel to the view");
  camera(R"("position": [0, 0, 1], "up": [0, 0, 0])", "/camera/up is zero");
}

TEST_F(SceneJson, refuses_what_it_cannot_open) {
  expect_refusal("absent.json: cannot open",
                 [&] { (void)load_scene_json(folder_.path / "absent.json"); });
  expect_refusal("absent.obj: cannot open", [&] { (void)load(R"({"geometry": "absent.obj"})"); });
  expect_refusal("x.abc: unknown kind of model '.abc'",
                 [&] { (void)load(R"({"geometry": "x.abc"})"); });
}

TEST_F(SceneJson, survives_deep_nesting) {
  const std::string deep(100000, '[');
  refuses_text(deep, "line 1, column 100001: ");
}

} // namespace
} // namespace lightcuts
