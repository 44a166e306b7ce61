// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/model_import.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/scene/bounds.h>
#include <nlohmann/json.hpp>

#include <tests/render/support/expect_near.h>
#include <tests/render/support/gltf_file.h>
#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";

bool has_note(const Scene& scene, const std::string& part) {
  return std::any_of(scene.notes.begin(), scene.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

class ModelImport : public testing::Test {
protected:
  Scene import(const std::string& name, const std::string& content) {
    write(folder_.path / name, content);
    return import_model(folder_.path / name);
  }
  void refuses(const std::string& name, const std::string& content, const std::string& part) {
    write(folder_.path / name, content);
    expect_refusal(name, [&] { (void)import_model(folder_.path / name); });
    expect_refusal(part, [&] { (void)import_model(folder_.path / name); });
  }
  void refuses_obj(const std::string& content, const std::string& part) {
    refuses("broken.obj", content, part);
  }

  TemporaryFolder folder_;
};

TEST_F(ModelImport, reads_quads_negative_indices_and_materials_of_an_obj) {
  write(folder_.path / "m.mtl", "newmtl shiny\nKa 9 9 9\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\n"
                                "Ke 1 2 3\nNs 37\nnewmtl unused\nKs 1 1 1\nnewmtl plain\n"
                                "Kd 0.5 0.5 0.5\n");
  const Scene scene = import("m.obj", "mtllib m.mtl\n" + triangle_obj +
                                          "v 0 1 0\nusemtl shiny\nf 1 2 3 4\nusemtl plain\n"
                                          "f -4 -3 -2\n");
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(scene.name, "m");
  ASSERT_EQ(scene.mesh.triangles.size(), 3U);
  ASSERT_EQ(scene.surfaces.size(), 2U);
  const Surface& shiny = scene.surfaces[scene.mesh.surface[0]];
  EXPECT_EQ(shiny.name, "shiny");
  EXPECT_EQ(shiny.material.diffuse, glm::vec3(0.1F, 0.2F, 0.3F));
  const auto& lobe = std::get<Phong>(shiny.material.lobe);
  EXPECT_EQ(lobe.reflectance, glm::vec3(0.4F, 0.5F, 0.6F));
  EXPECT_EQ(lobe.exponent, 37);
  EXPECT_EQ(shiny.emission, glm::vec3(1, 2, 3));
  const Surface& plain = scene.surfaces[scene.mesh.surface[2]];
  EXPECT_EQ(plain.name, "plain");
  EXPECT_FALSE(plain.material.is_glossy());
  EXPECT_EQ(plain.emission, glm::vec3(0));
  const Box box = scene_bounds(scene.mesh);
  EXPECT_EQ(box.lo, glm::vec3(0));
  EXPECT_EQ(box.hi, glm::vec3(1, 1, 0));
}

TEST_F(ModelImport, takes_normals_where_the_file_has_them) {
  const Scene with = import("n.obj", triangle_obj + "vn 0 0 2\nf 1//1 2//1 3//1\n");
  for (const glm::vec3& normal : with.mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
  const Scene without = import("o.obj", triangle_obj + "f 1 2 3\n");
  for (const glm::vec3& normal : without.mesh.normals) EXPECT_EQ(normal, glm::vec3(0));
}

TEST_F(ModelImport, takes_continued_lines_crlf_comments_lines_and_points) {
  const Scene scene = import("w.obj", "# made by hand\r\nv 0 0 0\r\nv +1 0 0 # right\r\n"
                                      "v 1 1e0 0\r\nl 1 2\r\np 1\r\nf 1 \\\r\n2 3\r\n");
  EXPECT_EQ(scene.mesh.triangles.size(), 1U);
}

TEST_F(ModelImport, drops_triangles_without_area_and_says_how_many) {
  const Scene scene = import("z.obj", triangle_obj + "v 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
  EXPECT_EQ(scene.mesh.triangles.size(), 1U);
  EXPECT_TRUE(has_note(scene, "2 triangles without area left out"));
}

TEST_F(ModelImport, clamps_a_huge_exponent_and_says_so) {
  write(folder_.path / "e.mtl", "newmtl mirror\nKs 1 1 1\nNs 1e9\n");
  const Scene scene = import("e.obj", "mtllib e.mtl\n" + triangle_obj + "usemtl mirror\nf 1 2 3\n");
  EXPECT_EQ(std::get<Phong>(scene.surfaces.at(0).material.lobe).exponent, Phong::max_exponent);
  EXPECT_TRUE(has_note(scene, "material 'mirror': exponent 1000000000 is clamped to 1048576"));
}

TEST_F(ModelImport, says_that_a_material_library_or_a_camera_is_missing) {
  const Scene scene =
      import("a.obj", "mtllib no such.mtl\n" + triangle_obj + "usemtl x\nf 1 2 3\n");
  EXPECT_TRUE(has_note(scene, "a.obj: material library 'no such.mtl' not found"));
  EXPECT_TRUE(has_note(scene, "a.obj: no camera in the file: framed"));
}

TEST_F(ModelImport, refuses_materials_outside_their_domain) {
  const auto refuses_mtl = [&](const std::string& mtl, const std::string& part) {
    write(folder_.path / "b.mtl", "newmtl bad\n" + mtl);
    refuses("b.obj", "mtllib b.mtl\n" + triangle_obj + "usemtl bad\nf 1 2 3\n", part);
  };
  refuses_mtl("Ns -5\n", "b.obj: material 'bad': exponent is -5");
  refuses_mtl("Ns nan\n", "b.obj: material 'bad': exponent is nan");
  refuses_mtl("Ns inf\n", "b.obj: material 'bad': exponent is inf");
  refuses_mtl("Kd -1 0 0\n", "b.obj: material 'bad': diffuse.r is -1");
  refuses_mtl("Ks 0 inf 0\n", "material 'bad': specular.g is inf");
  refuses_mtl("Ke 0 0 -2\n", "material 'bad': emission.b is -2");
}

TEST_F(ModelImport, refuses_a_truncated_material_library) {
  write(folder_.path / "t.mtl", "newmtl cut\nKs 0 0 0\nKd 0.5 0.");
  EXPECT_THROW((void)import("t.obj", "mtllib t.mtl\n" + triangle_obj + "f 1 2 3\n"), InputError);
  expect_refusal("t.mtl:3: 'Kd' with 2 values, expected 3",
                 [&] { (void)import_model(folder_.path / "t.obj"); });
}

TEST_F(ModelImport, refuses_an_obj_that_is_cut_off_within_a_line) {
  refuses_obj(triangle_obj + "f 1 2 3\nf 1 2", "broken.obj:5: a face with 2 corners");
  refuses_obj(triangle_obj + "f 1 2 3\nf", "broken.obj:5: a face with 0 corners");
  refuses_obj(triangle_obj + "vt 0 0\nf 1/1 2/1 3", "broken.obj:5: corner '3' lacks what");
  refuses_obj(triangle_obj + "f 1/", "broken.obj:4: a face with 1 corners");
  refuses_obj(triangle_obj + "vt 0 0\nf 1/1 2/1 3/", "broken.obj:5: corner '3/' lacks what");
  refuses_obj(triangle_obj + "f 1 2 3\nv 1.0", "broken.obj:5: 'v' with 1 values, expected 3");
  refuses_obj(triangle_obj + "f 1 2 3\nv 1.0 2.0 -", "broken.obj:5: '-' is not a number");
  refuses_obj(triangle_obj + "f 1 2 3\nvn 1.0 0", "broken.obj:5: 'vn' with 2 values");
}

TEST_F(ModelImport, refuses_indices_that_are_out_of_range) {
  refuses_obj(triangle_obj + "f 1 2 9\n", "a face uses position 9, of 3");
  refuses_obj(triangle_obj + "vn 0 0 1\nf 1//1 2//1 3//2\n", "a face uses normal 2, of 1");
  refuses_obj(triangle_obj + "f 1/1 2/1 3/1\n", "a face uses texture coordinate 1, of 0");
  refuses_obj(triangle_obj + "f -1 -2 -9\n", "broken.obj:4: index -9 is out of range");
  refuses_obj(triangle_obj + "f 0 1 2\n", "broken.obj:4: index 0 is out of range");
  refuses_obj(triangle_obj + "f a b c\n", "broken.obj:4: 'a' is not an index");
  refuses_obj(triangle_obj + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2/1/1/1 3/1/1/1\n",
              "broken.obj:6: a face's corner has more than three indices");
}

TEST_F(ModelImport, refuses_coordinates_that_are_no_finite_floats) {
  refuses_obj(triangle_obj + "v a b c\nf 1 2 3\n", "broken.obj:4: 'a' is not a number");
  refuses_obj("v 1e999 0 0\n" + triangle_obj + "f 1 2 3\n", "broken.obj:1: 1e999 is out of range");
  refuses_obj("v 1e39 0 0\n" + triangle_obj + "f 1 2 3\n", "broken.obj:1: 1e39 is out of range");
  refuses_obj("v nan 0 0\n" + triangle_obj + "f 1 2 3\n", "vertex 0 is not finite");
  EXPECT_NO_THROW((void)import("tiny.obj", "v 1e-999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
}

TEST_F(ModelImport, refuses_files_without_triangles) {
  refuses_obj(triangle_obj, "no triangles");
  refuses_obj(triangle_obj + "v 2 0 0\nf 1 2 4\n", "no triangles");
  refuses_obj(std::string(500, '\x01'), "no triangles");
  refuses_obj("", "broken.obj");
  nlohmann::json gltf = test::gltf();
  gltf["nodes"][1].erase("mesh");
  gltf.erase("meshes");
  refuses("empty.gltf", gltf.dump(), "empty.gltf: no triangles");
}

TEST_F(ModelImport, refuses_what_it_cannot_open) {
  for (const std::string name : {"absent.obj", "absent.gltf", "absent.glb"})
    expect_refusal(name + ": cannot open", [&] { (void)import_model(folder_.path / name); });
  std::filesystem::create_directory(folder_.path / "folder.obj");
  expect_refusal("folder.obj: cannot open",
                 [&] { (void)import_model(folder_.path / "folder.obj"); });
  refuses("model.fbx", "x", "unknown kind of model '.fbx'; known: .obj, .gltf, .glb");
}

TEST_F(ModelImport, applies_the_nodes_transforms_of_a_gltf) {
  const Scene scene = import("a.gltf", test::gltf().dump());
  ASSERT_EQ(scene.mesh.triangles.size(), 1U);
  const glm::uvec3 t = scene.mesh.triangles[0];
  // A quarter turn about z after a scale by 2, under a parent that shifts by (1, 2, 3).
  expect_near(scene.mesh.positions[t.x], {1, 2, 3});
  expect_near(scene.mesh.positions[t.y], {1, 4, 3});
  expect_near(scene.mesh.positions[t.z], {-1, 2, 3});
  EXPECT_NO_THROW(validate(scene));
}

TEST_F(ModelImport, turns_the_normals_of_a_gltf_and_keeps_the_outside_outside) {
  nlohmann::json gltf = test::gltf();
  gltf["nodes"][1]["scale"] = {-2, 1, 4}; // mirrors
  const Scene scene = import("n.gltf", gltf.dump());
  const glm::uvec3 t = scene.mesh.triangles.at(0);
  const glm::vec3 a = scene.mesh.positions[t.x], b = scene.mesh.positions[t.y],
                  c = scene.mesh.positions[t.z];
  expect_near(scene.mesh.normals[t.x], {0, 0, 1});
  EXPECT_GT(glm::dot(glm::cross(b - a, c - a), scene.mesh.normals[t.x]), 0);
}

TEST_F(ModelImport, keeps_normals_normal_under_an_uneven_scale) {
  std::string bytes = test::buffer();
  const float tilted[3] = {0.6F, 0, 0.8F};
  for (int vertex = 0; vertex < 3; ++vertex) std::memcpy(&bytes[36 + 12 * vertex], tilted, 12);
  nlohmann::json gltf = test::gltf(bytes);
  gltf["nodes"][1]["scale"] = {1, 1, 2};
  for (const glm::vec3& normal : import("u.gltf", gltf.dump()).mesh.normals)
    expect_near(normal, glm::normalize(glm::vec3(0, 0.6F, 0.4F))); // x turned into y, z halved
}

TEST_F(ModelImport, reads_metallic_roughness_as_cook_torrance) {
  const Scene scene = import("a.gltf", test::gltf().dump());
  const Surface& surface = scene.surfaces.at(0);
  EXPECT_EQ(surface.name, "paint");
  expect_near(surface.material.diffuse, glm::vec3(0.8F, 0.6F, 0.4F) * 0.75F * 0.96F);
  const auto& lobe = std::get<CookTorrance>(surface.material.lobe);
  expect_near(lobe.f0, glm::vec3(0.23F, 0.18F, 0.13F));
  EXPECT_FLOAT_EQ(lobe.alpha, 0.25F); // the square of roughness
  expect_near(surface.emission, {0.1F, 0.2F, 0.3F});
}

TEST_F(ModelImport, maps_the_ends_of_roughness_into_alphas_domain) {
  for (const auto& [roughness, alpha] : {std::pair{0.0, CookTorrance::min_alpha}, {1.0, 1.0F}}) {
    nlohmann::json gltf = test::gltf();
    gltf["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = roughness;
    const Material material = import("r.gltf", gltf.dump()).surfaces.at(0).material;
    EXPECT_EQ(std::get<CookTorrance>(material.lobe).alpha, alpha);
  }
}

TEST_F(ModelImport, reads_the_camera_of_a_gltf) {
  const Scene scene = import("a.gltf", test::gltf().dump());
  expect_near(scene.camera.position, {1, 2, 8});
  const glm::vec3 view = glm::normalize(scene.camera.target - scene.camera.position);
  expect_near(view, {0, 0, -1});
  expect_near(scene.camera.up, {0, 1, 0});
  EXPECT_NEAR(scene.camera.vertical_fov, 0.7 * 180 / 3.14159265358979,
              1e-4); // not times the aspect
  EXPECT_FALSE(has_note(scene, "no camera"));
}

TEST_F(ModelImport, frames_a_gltf_that_has_an_orthographic_camera_only) {
  nlohmann::json gltf = test::gltf();
  gltf["cameras"][0] = {{"type", "orthographic"},
                        {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}};
  const Scene scene = import("o.gltf", gltf.dump());
  EXPECT_TRUE(has_note(scene, "1 orthographic camera left out"));
  EXPECT_TRUE(has_note(scene, "no camera in the file: framed"));
}

TEST_F(ModelImport, reads_the_lights_of_a_gltf) {
  nlohmann::json gltf = test::gltf();
  const double half = 0.7071067811865476;
  gltf["nodes"][5]["rotation"] = {-half, 0, 0, half}; // -z becomes -y
  gltf["nodes"][5]["scale"] = {3, 3, 3};
  gltf["nodes"][6]["translation"] = {1, 2, 3};
  gltf["nodes"][6]["rotation"] = {0, half, 0, half}; // -z becomes -x
  auto& lights = gltf["extensions"]["KHR_lights_punctual"]["lights"];
  lights[1]["intensity"] = 3;
  lights[2]["spot"]["innerConeAngle"] = 0.25;
  const Scene scene = import("a.gltf", gltf.dump());
  // The first light is used by two nodes, which have the same name.
  ASSERT_EQ(scene.lights.size(), 4U);
  for (const int i : {0, 1}) {
    EXPECT_EQ(scene.lights[i].kind, LightKind::omni);
    EXPECT_EQ(scene.lights[i].intensity, glm::vec3(8, 4, 2));
  }
  expect_near(scene.lights[0].position, {4, 6, 8});
  expect_near(scene.lights[1].position, {-1, 0, 0});
  EXPECT_EQ(scene.lights[2].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[2].intensity, glm::vec3(3));
  expect_near(scene.lights[2].position, {0, 1, 0}); // it comes from above
  EXPECT_EQ(scene.lights[3].kind, LightKind::spot);
  EXPECT_EQ(scene.lights[3].intensity, glm::vec3(1));
  expect_near(scene.lights[3].position, {1, 2, 3});
  expect_near(scene.lights[3].axis, {-1, 0, 0});
  EXPECT_FLOAT_EQ(scene.lights[3].cos_inner, std::cos(0.25F));
  EXPECT_FLOAT_EQ(scene.lights[3].cos_outer, std::cos(0.5F));
  EXPECT_TRUE(scene.notes.empty());
}

TEST_F(ModelImport, leaves_out_lights_of_a_gltf_whose_kind_it_does_not_know) {
  nlohmann::json gltf = test::gltf();
  gltf["extensions"]["KHR_lights_punctual"]["lights"][2]["type"] = "tube";
  const Scene scene = import("t.gltf", gltf.dump());
  ASSERT_EQ(scene.lights.size(), 3U);
  for (const Light& light : scene.lights) EXPECT_NE(light.kind, LightKind::spot);
}

TEST_F(ModelImport, gives_a_spot_of_a_gltf_the_formats_default_angles) {
  nlohmann::json gltf = test::gltf();
  gltf["extensions"]["KHR_lights_punctual"]["lights"][2]["spot"] = nlohmann::json::object();
  const Light spot = import("s.gltf", gltf.dump()).lights[3];
  EXPECT_EQ(spot.cos_inner, 1);
  EXPECT_FLOAT_EQ(spot.cos_outer, std::sqrt(0.5F));
}

TEST_F(ModelImport, reads_a_binary_gltf_alike) {
  const Scene text = import("a.gltf", test::gltf().dump());
  const Scene binary = import("a.glb", test::glb(test::gltf()));
  EXPECT_EQ(text.mesh.positions, binary.mesh.positions);
  EXPECT_EQ(text.lights.size(), binary.lights.size());
  EXPECT_EQ(text.camera.position, binary.camera.position);
  EXPECT_NO_THROW((void)import("UPPER.GLB", test::glb(test::gltf())));
}

TEST_F(ModelImport, refuses_a_gltf_that_is_cut_off_anywhere) {
  const std::string text = test::gltf().dump(), binary = test::glb(test::gltf());
  for (std::size_t n = 0; n < text.size(); n += 37)
    refuses("cut.gltf", text.substr(0, n), "cut.gltf");
  for (std::size_t n = 0; n < binary.size(); n += 37)
    refuses("cut.glb", binary.substr(0, n), "cut.glb");
  refuses("cut.glb", binary.substr(0, binary.size() - 1), "truncated");
  refuses("cut.gltf", "{\n  \"asset\": }", "line 2, column 12");
}

TEST_F(ModelImport, refuses_a_missing_and_a_short_buffer) {
  nlohmann::json gltf = test::gltf();
  gltf["buffers"][0]["uri"] = "absent.bin";
  refuses("b.gltf", gltf.dump(), "b.gltf: cannot open its buffer 'absent.bin'");
  gltf["buffers"][0]["uri"] = "short.bin";
  write(folder_.path / "short.bin", test::buffer().substr(0, 20));
  refuses("b.gltf", gltf.dump(), "b.gltf: its buffer 'short.bin' is truncated: 20 bytes of 80");
  write(folder_.path / "short.bin", test::buffer());
  EXPECT_NO_THROW((void)import("b.gltf", gltf.dump()));
}

TEST_F(ModelImport, refuses_bad_values_in_a_gltf) {
  const auto refuses_change = [&](const std::string& part, auto&& change) {
    nlohmann::json gltf = test::gltf();
    change(gltf);
    refuses("v.gltf", gltf.dump(), part);
  };
  refuses_change("mesh 'shape': vertex 0 is not finite", [](auto& g) {
    g["nodes"][0]["translation"] = {1e39, 0, 0};
  });
  refuses_change("material 'paint': roughnessFactor is -1", [](auto& g) {
    g["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = -1;
  });
  refuses_change("material 'paint': diffuse.r is", [](auto& g) {
    g["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {-1, 1, 1, 1};
  });
  refuses_change("v.gltf: light 0: intensity.r is -8", [](auto& g) {
    g["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = -8;
  });
  refuses_change("v.gltf: light 3: outer angle is 4, expected", [](auto& g) {
    g["extensions"]["KHR_lights_punctual"]["lights"][2]["spot"]["outerConeAngle"] = 4;
  });
  refuses_change("v.gltf: light 2: irradiance.r is -1, negative", [](auto& g) {
    g["extensions"]["KHR_lights_punctual"]["lights"][1]["intensity"] = -1;
  });
  refuses_change("v.gltf: not glTF 2.0", [](auto& g) {
    g["extensions"]["KHR_lights_punctual"]["lights"][2].erase("spot");
  });
  refuses_change("v.gltf: not glTF 2.0", [](auto& g) { g["asset"]["version"] = "1.0"; });
  refuses_change("v.gltf: not glTF 2.0", [](auto& g) { g.erase("asset"); });
  refuses_change("node 0 has more than one parent",
                 [](auto& g) { g["nodes"][1]["children"] = {0}; });
  refuses_change("v.gltf: not glTF 2.0", [](auto& g) { g["nodes"][0]["children"] = {99}; });
}

TEST_F(ModelImport, refuses_a_vertex_that_is_not_a_number) {
  std::string bytes = test::buffer();
  std::memcpy(bytes.data() + 12, &nan, 4);
  refuses("nan.gltf", test::gltf(bytes).dump(), "mesh 'shape': vertex 1 is not finite");
}

TEST_F(ModelImport, refuses_an_index_out_of_range_in_a_gltf) {
  std::string bytes = test::buffer();
  bytes[72] = 7;
  refuses("index.gltf", test::gltf(bytes).dump(), "index.gltf");
}

TEST_F(ModelImport, writes_nothing_to_stdout) {
  testing::internal::CaptureStdout();
  EXPECT_NO_THROW((void)import("a.gltf", test::gltf().dump()));
  EXPECT_THROW((void)import("b.obj", "f 1 2"), InputError);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(ModelImport, appends_a_model_to_a_scene) {
  Scene scene = import("a.obj", triangle_obj + "f 1 2 3\n");
  write(folder_.path / "b.gltf", test::gltf().dump());
  EXPECT_TRUE(append_model(folder_.path / "b.gltf", scene));
  EXPECT_EQ(scene.mesh.triangles.size(), 2U);
  EXPECT_EQ(scene.surfaces.size(), 2U);
  EXPECT_EQ(scene.surfaces[scene.mesh.surface[1]].name, "paint");
  EXPECT_NO_THROW(validate(scene));
}

/// Whether the camera's view of a 4:3 image holds the point.
bool sees(const Camera& camera, const glm::dvec3& p) {
  const glm::dvec3 forward =
      glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 d = p - glm::dvec3(camera.position);
  const double reach = glm::dot(d, forward) * std::tan(camera.vertical_fov * 3.14159265 / 360);
  return std::abs(glm::dot(d, glm::cross(right, forward))) <= reach &&
         std::abs(glm::dot(d, right)) <= reach * 4 / 3;
}

void expect_to_see_all(const Scene& scene) {
  for (const glm::uvec3& t : scene.mesh.triangles)
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(sees(scene.camera, scene.mesh.positions[t[i]]));
}

TEST_F(ModelImport, frames_a_solid_at_three_quarters_from_above) {
  const Scene scene =
      import("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                      "f 1 3 4 2\nf 5 6 8 7\nf 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\n");
  expect_to_see_all(scene);
  EXPECT_GT(scene.camera.position.y, 1);
  EXPECT_GT(scene.camera.position.z, 1);
}

TEST_F(ModelImport, reads_the_cornell_box_and_looks_in_at_its_open_side) {
  const std::filesystem::path file =
      std::filesystem::path(LIGHTCUTS_SHARED_DIR) / "scenes/cornell_box/cornell_box.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Scene scene = import_model(file);
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(scene.mesh.triangles.size(), 34U);
  EXPECT_EQ(scene.surfaces.size(), 3U); // white, green, red; light and blue are commented out
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_LT(scene.camera.position.z, 0);
  EXPECT_NEAR(scene.camera.position.x, scene.camera.target.x, 1e-3);
  expect_to_see_all(scene);
}

TEST_F(ModelImport, reads_the_hot_air_balloon) {
  const std::filesystem::path file =
      std::filesystem::path(LIGHTCUTS_SHARED_DIR) / "scenes/hot_air_balloon/scene.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Scene scene = import_model(file);
  EXPECT_NO_THROW(validate(scene));
  EXPECT_GT(scene.mesh.triangles.size(), 10000U);
  EXPECT_EQ(scene.textures.size(), 17U);
  EXPECT_FALSE(has_note(scene, "texture"));
  expect_to_see_all(scene);
}

} // namespace
} // namespace lightcuts
