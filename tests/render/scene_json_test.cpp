// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene_json.h>

#include <string>

#include <gtest/gtest.h>
#include <lightcuts/render/light_generator.h>
#include <lightcuts/render/open_scene.h>
#include <nlohmann/json.hpp>

#include "gltf_file.h"
#include "refusal.h"
#include "temporary_folder.h"

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
  EXPECT_EQ(scene.lights.size(), 2U);
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
  refuses(R"("lamps": 5)", "/lamps is unknown; known: geometry, camera, image, lights");
  refuses(R"("camera": {"position": [0, 0, 1], "target": [0, 0, 0], "fovy": 4})",
          "/camera/fovy is unknown; known: position, target, up, fov");
  refuses(R"("camera": {"position": [0, 0, 1]})", "/camera/target is missing");
  refuses(R"("image": {"width": 5})", "/image/height is missing");
  refuses(R"("image": {"width": 5, "height": 5, "depth": 5})", "/image/depth is unknown");
  refuses(R"("lights": [{"position": [0, 0, 0]}])", "/lights/0/intensity is missing");
  refuses(R"("lights": [{"position": [0, 0, 0], "intensity": 1, "color": 2}])",
          "/lights/0/color is unknown; known: position, intensity");
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
