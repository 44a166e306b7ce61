// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/open_scene.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <tests/render/support/gltf_file.h>
#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

TEST(OpenScene, opens_every_kind) {
  const TemporaryFolder folder;
  write(folder.path / "a.obj", obj);
  write(folder.path / "b.GLTF", test::gltf().dump());
  write(folder.path / "c.glb", test::glb(test::gltf()));
  write(folder.path / "d.Json", R"({"geometry": "a.obj"})");
  for (const std::string name : {"a.obj", "b.GLTF", "c.glb", "d.Json"}) {
    const Scene scene = open_scene((folder.path / name).string());
    EXPECT_EQ(scene.mesh.triangles.size(), 1U) << name;
    EXPECT_EQ(scene.name, name.substr(0, 1));
  }
  EXPECT_EQ(open_scene("desk").name, "desk");
  EXPECT_EQ(open_scene("cloud?lights=7&blocks=0").lights.size(), 7U);
  EXPECT_EQ(open_scene("cloud?lights=7&blocks=0").name, "cloud?lights=7&blocks=0");
}

TEST(OpenScene, is_not_confused_by_question_marks_in_file_names) {
  const TemporaryFolder folder;
  write(folder.path / "what?.obj", obj);
  write(folder.path / "cloud?lights=3.obj", obj);
  for (const std::string name : {"what?.obj", "cloud?lights=3.obj"})
    EXPECT_EQ(open_scene((folder.path / name).string()).mesh.triangles.size(), 1U);
}

TEST(OpenScene, refuses_what_it_does_not_know) {
  const auto refuses = [](const std::string& spec, const std::string& part) {
    expect_refusal(part, [&] { (void)open_scene(spec); });
  };
  refuses("foo.xyz", "foo.xyz: unknown kind of scene '.xyz'; known: a built-in name, .json, .obj, "
                     ".gltf, .glb");
  refuses("./foo", "./foo: unknown kind of scene ''");
  refuses("/", "unknown kind of scene");
  refuses("foo", "unknown built-in scene 'foo'; known: desk, desk-red, bedroom, cloud");
  refuses("", "unknown built-in scene ''");
  refuses("foo?lights=3", "unknown built-in scene 'foo'");
  refuses("what?.obj", "what?.obj: cannot open");
  refuses("/nowhere/a.json", "/nowhere/a.json: cannot open");
  refuses("cloud?seed=1.5", "cloud: parameter 'seed' is '1.5', expected a whole number");
  refuses("cloud?light=3", "cloud: parameter 'light' is unknown");
}

TEST(OpenScene, says_in_one_line_what_it_refuses_whatever_files_are_called) {
  const TemporaryFolder folder;
  write(folder.path / "a.json", "{\"geometry\": \"a\\nb\"}");
  expect_refusal("a b: unknown kind of model",
                 [&] { (void)open_scene((folder.path / "a.json").string()); });
}

TEST(OpenScene, says_why_it_refuses) {
  const TemporaryFolder folder;
  write(folder.path / "a.obj", obj);
  const auto refuses = [](const std::string& spec, InputFault fault) {
    expect_fault(fault, [&] { (void)open_scene(spec); });
  };
  refuses("foo", InputFault::unknown_name);
  refuses("foo.xyz", InputFault::unsupported);
  refuses("/nowhere/a.json", InputFault::unreadable_file);
  refuses("/nowhere/a.obj", InputFault::unreadable_file);
  refuses("cloud?lights=0", InputFault::out_of_domain);
  const auto refuses_json = [&](const std::string& text, InputFault fault) {
    write(folder.path / "a.json", text);
    refuses((folder.path / "a.json").string(), fault);
  };
  refuses_json("{", InputFault::malformed_file);
  refuses_json("[]", InputFault::malformed_file);
  refuses_json("{}", InputFault::missing);
  refuses_json(R"({"geometry": "a.obj", "colour": 1})", InputFault::unknown_name);
  refuses_json(R"({"geometry": "a.obj", "lights": [{"position": [0, 0, 0], "intensity": -1}]})",
               InputFault::negative);
  // Found by a function that knows nothing of the file.
  refuses_json(R"({"geometry": "a.obj", "lights": [{"generate": "area", "count": 3}]})",
               InputFault::missing);
  refuses_json(R"({"geometry": "b.obj"})", InputFault::unreadable_file);
  write(folder.path / "b.obj", "v 0 0\n");
  refuses((folder.path / "b.obj").string(), InputFault::malformed_file);
}

Scene valid_scene() {
  Scene scene;
  scene.name = "test";
  scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  scene.mesh.normals = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  scene.mesh.triangles = {{0, 1, 2}};
  scene.mesh.surface = {0};
  scene.surfaces = {{"paint", {{0.5F, 0.5F, 0.5F}, {}}}};
  return scene;
}

TEST(Validate, takes_a_valid_scene_without_lights) { EXPECT_NO_THROW(validate(valid_scene())); }

TEST(Validate, refuses_broken_scenes) {
  const auto refuses = [](const std::string& part, auto&& change) {
    Scene scene = valid_scene();
    change(scene);
    expect_refusal("test: " + part, [&] { validate(scene); });
  };
  refuses("no triangles", [](Scene& s) { s.mesh.triangles.clear(); });
  refuses("2 normals for 3 positions", [](Scene& s) { s.mesh.normals.pop_back(); });
  refuses("0 surface indices for 1 triangles", [](Scene& s) { s.mesh.surface.clear(); });
  refuses("triangle 0 uses position 3 of 3", [](Scene& s) { s.mesh.triangles[0].z = 3; });
  refuses("triangle 0 uses surface 1 of 1", [](Scene& s) { s.mesh.surface[0] = 1; });
  refuses("position 1 is not finite", [&](Scene& s) { s.mesh.positions[1].y = inf; });
  refuses("normal 1 has length 2", [](Scene& s) { s.mesh.normals[1].z = 2; });
  refuses("normal 1 has length nan", [&](Scene& s) { s.mesh.normals[1].z = nan; });
  refuses("1 texture coordinates for 3 positions", [](Scene& s) { s.mesh.uv = {{0, 0}}; });
  refuses("texture coordinate 2 is not finite", [&](Scene& s) {
    s.mesh.uv = {{0, 0}, {0, 0}, {0, nan}};
  });
  refuses("surface 'paint': diffuse.g is -1",
          [](Scene& s) { s.surfaces[0].material.diffuse.g = -1; });
  refuses("surface 'paint': exponent is nan", [&](Scene& s) {
    s.surfaces[0].material.lobe = Phong{{}, nan};
  });
  refuses("surface 'paint': emission.r is -1", [](Scene& s) { s.surfaces[0].emission.r = -1; });
  refuses("camera: fov is 180", [](Scene& s) { s.camera.vertical_fov = 180; });
  refuses("camera: fov is nan", [&](Scene& s) { s.camera.vertical_fov = nan; });
  refuses("camera: position equals target", [](Scene& s) { s.camera.position = s.camera.target; });
  refuses("camera: position is not finite", [&](Scene& s) { s.camera.position.x = nan; });
  refuses("camera: target is not finite", [&](Scene& s) { s.camera.target.x = inf; });
  refuses("camera: up is not finite", [&](Scene& s) { s.camera.up.x = nan; });
  refuses("camera: up is zero", [](Scene& s) { s.camera.up = glm::vec3(0); });
  refuses("camera: up is parallel to the view", [](Scene& s) { s.camera.up = {0, 0, 4}; });
  refuses("image width is 0, expected 1 to 16384", [](Scene& s) { s.image_size.x = 0; });
  refuses("image height is 16385", [](Scene& s) { s.image_size.y = 16385; });
}

Scene textured_scene() {
  Scene scene = valid_scene();
  scene.mesh.uv = {{0, 0}, {1, 0}, {-7, 1e30F}};
  scene.textures.emplace_back(glm::uvec2(1), std::vector<glm::vec3>{{1, 1, 1}});
  scene.surfaces[0].material.lobe = CookTorrance{{0.5F, 0.25F, 0}, 0.5F};
  scene.surfaces[0].tinted_f0 = {0.5F, 0, 0};
  scene.surfaces[0].texture = SurfaceTexture{};
  scene.mesh.emission_uv = scene.mesh.uv;
  scene.mesh.colours.assign(3, glm::vec3(0.5F));
  scene.surfaces[0].emission_texture = SurfaceTexture{};
  return scene;
}

TEST(Validate, refuses_broken_colours_and_coordinates_of_emission) {
  const auto refuses = [](const std::string& part, auto&& change) {
    Scene scene = textured_scene();
    change(scene);
    expect_refusal("test: " + part, [&] { validate(scene); });
  };
  refuses("2 colours for 3 positions", [](Scene& s) { s.mesh.colours.resize(2); });
  refuses("colour 1.g is -1", [](Scene& s) { s.mesh.colours[1].g = -1; });
  refuses("colour 2.b is nan", [](Scene& s) { s.mesh.colours[2].b = std::nanf(""); });
  refuses("1 texture coordinates for 3", [](Scene& s) { s.mesh.emission_uv.resize(1); });
  refuses("texture coordinate 0 is not finite",
          [](Scene& s) { s.mesh.emission_uv[0].x = std::nanf(""); });
}

TEST(Validate, refuses_broken_textures) {
  EXPECT_NO_THROW(validate(textured_scene()));
  const auto refuses = [](const std::string& part, auto&& change) {
    Scene scene = textured_scene();
    change(scene);
    expect_refusal("test: surface 'paint': " + part, [&] { validate(scene); });
  };
  refuses("texture 1 of 1", [](Scene& s) { s.surfaces[0].texture->index = 1; });
  refuses("a texture, but the mesh has no texture coordinates", [](Scene& s) { s.mesh.uv = {}; });
  refuses("texture 7 of 1", [](Scene& s) { s.surfaces[0].emission_texture->index = 7; });
  refuses("a texture, but the mesh has no texture coordinates",
          [](Scene& s) { s.mesh.emission_uv = {}; });
  refuses("tinted_f0.g is 0.5, expected 0 to 0.25",
          [](Scene& s) { s.surfaces[0].tinted_f0.g = 0.5F; });
  refuses("tinted_f0.r is -1", [](Scene& s) { s.surfaces[0].tinted_f0.r = -1; });
  refuses("tinted_f0.b is nan", [](Scene& s) { s.surfaces[0].tinted_f0.b = std::nanf(""); });
}

} // namespace
} // namespace lightcuts
