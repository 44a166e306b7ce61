// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/model_import.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/scene_view.h>
#include <nlohmann/json.hpp>

#include <tests/render/support/expect_near.h>
#include <tests/render/support/gltf_file.h>
#include <tests/render/support/image_bytes.h>
#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

using nlohmann::json;

/// The colours of test::four_colours().
const glm::vec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1, 1, 1);

const std::string square_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string square_face = "f 1/1 2/2 3/3 4/4\n";

class ImportedTexture : public testing::Test {
protected:
  ImportedTexture() { write_image("four.png"); }

  void write_image(const std::string& name, const std::string& bytes = test::four_colours()) {
    write(folder_.path / name, bytes);
  }
  Scene import(const std::string& name, const std::string& content) {
    write(folder_.path / name, content);
    Scene scene = import_model(folder_.path / name);
    EXPECT_NO_THROW(validate(scene));
    return scene;
  }
  Scene import_square_obj(const std::string& mtl, const std::string& geometry = square_obj) {
    write(folder_.path / "s.mtl", "newmtl paint\n" + mtl);
    return import("s.obj", "mtllib s.mtl\n" + geometry + "usemtl paint\n" + square_face);
  }
  Scene import_square_gltf(const json& image) {
    return import("s.gltf", test::textured_square(image).dump());
  }

  TemporaryFolder folder_;
};

/// The materials of the square's four quarters: top left, top right, bottom left, bottom right.
std::array<Material, 4> quarters(Scene scene) {
  scene.camera = {{0.5F, 0.5F, 1}, {0.5F, 0.5F, 0}, {0, 1, 0}, 53.130102F};
  scene.image_size = {2, 2};
  const SceneView view(scene);
  std::array<Material, 4> materials;
  for (unsigned i = 0; i < 4; ++i) {
    const auto seen = view.at({i % 2, i / 2});
    EXPECT_TRUE(seen);
    if (seen) materials[i] = seen->point.material();
  }
  return materials;
}

void expect_diffuse(const Scene& scene, const std::array<glm::vec3, 4>& expected) {
  const std::array<Material, 4> seen = quarters(scene);
  for (unsigned i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    expect_near(seen[i].diffuse, expected[i]);
  }
}

/// The four colours times a factor.
std::array<glm::vec3, 4> four(const glm::vec3& factor = white) {
  return {red * factor, green * factor, blue * factor, white * factor};
}

const glm::vec3 gltf_diffuse = glm::vec3(0.8F, 0.6F, 0.4F) * 0.75F * 0.96F;

std::size_t notes_with(const Scene& scene, const std::string& part) {
  return std::count_if(scene.notes.begin(), scene.notes.end(), [&](const std::string& note) {
    return note.find(part) != std::string::npos;
  });
}

TEST_F(ImportedTexture, of_an_obj_stands_upright_and_multiplies_kd_alone) {
  const Scene scene =
      import_square_obj("Kd 0.5 0.25 0.75\nKs 0.1 0.2 0.3\nNs 9\nmap_Kd four.png\n");
  expect_diffuse(scene, four({0.5F, 0.25F, 0.75F}));
  for (const Material& material : quarters(scene))
    EXPECT_EQ(std::get<Phong>(material.lobe).reflectance, glm::vec3(0.1F, 0.2F, 0.3F));
}

TEST_F(ImportedTexture, of_a_gltf_stands_upright_and_multiplies_the_base_colour) {
  const Scene scene = import_square_gltf({{"uri", "four.png"}});
  expect_diffuse(scene, four(gltf_diffuse));
  const std::array<Material, 4> seen = quarters(scene);
  const glm::vec3 base(0.8F, 0.6F, 0.4F);
  for (unsigned i = 0; i < 4; ++i)
    expect_near(std::get<CookTorrance>(seen[i].lobe).f0,
                glm::mix(glm::vec3(0.04F), base * four()[i], 0.25F));
}

TEST_F(ImportedTexture, colours_all_of_a_metal_and_nothing_of_a_dielectrics_reflection) {
  for (const float metallic : {0.0F, 1.0F}) {
    json gltf = test::textured_square({{"uri", "four.png"}});
    gltf["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = metallic;
    const std::array<Material, 4> seen = quarters(import("m.gltf", gltf.dump()));
    for (unsigned i = 0; i < 4; ++i)
      expect_near(std::get<CookTorrance>(seen[i].lobe).f0,
                  metallic == 0 ? glm::vec3(0.04F) : glm::vec3(0.8F, 0.6F, 0.4F) * four()[i]);
  }
}

TEST_F(ImportedTexture, comes_out_of_a_data_uri) {
  const std::string uri = "data:image/png;base64," + test::base64(test::four_colours());
  expect_diffuse(import_square_gltf({{"uri", uri}}), four(gltf_diffuse));
}

TEST_F(ImportedTexture, comes_out_of_the_buffer_of_a_glb) {
  const std::string image = test::four_colours();
  std::string bytes = test::square_buffer() + image;
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  json gltf = test::textured_square({{"bufferView", 3}, {"mimeType", "image/png"}}, bytes);
  gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 92}, {"byteLength", image.size()}});
  expect_diffuse(import("s.glb", test::glb(gltf, bytes)), four(gltf_diffuse));
}

TEST_F(ImportedTexture, is_found_relative_to_the_model_whatever_its_name) {
  std::filesystem::create_directory(folder_.path / "sub dir");
  write_image("sub dir/a b.png");
  expect_diffuse(import_square_gltf({{"uri", "sub dir/a b.png"}}), four(gltf_diffuse));
  expect_diffuse(import_square_gltf({{"uri", "sub%20dir/a%20b.png"}}), four(gltf_diffuse));
  expect_diffuse(import_square_obj("Kd 1 1 1\nmap_Kd sub dir/a b.png\n"), four());
  expect_diffuse(import_square_obj("Kd 1 1 1\nmap_Kd sub dir\\a b.png\n"), four());
  expect_diffuse(
      import_square_obj("Kd 1 1 1\nmap_Kd " + (folder_.path / "four.png").string() + "\n"), four());
}

TEST_F(ImportedTexture, is_wrapped_as_the_sampler_says) {
  for (const auto& [code, wrap] :
       {std::pair{10497, Wrap::repeat}, {33648, Wrap::mirror}, {33071, Wrap::clamp}}) {
    json gltf = test::textured_square({{"uri", "four.png"}});
    gltf["samplers"] = {{{"wrapS", code}, {"wrapT", 10497}}, {{"wrapT", code}}};
    for (const int sampler : {0, 1}) {
      gltf["textures"][0]["sampler"] = sampler;
      const Scene scene = import("w.gltf", gltf.dump());
      const TextureWrap& read = scene.surfaces.at(0).texture.value().wrap;
      EXPECT_EQ(sampler == 0 ? read.u : read.v, wrap) << code;
      EXPECT_EQ(sampler == 0 ? read.v : read.u, Wrap::repeat) << code;
    }
  }
  const Scene clamped = import_square_obj("Kd 1 1 1\nmap_Kd -clamp on four.png\n");
  EXPECT_EQ(clamped.surfaces.at(0).texture.value().wrap.u, Wrap::clamp);
  EXPECT_EQ(clamped.surfaces.at(0).texture.value().wrap.v, Wrap::clamp);
}

TEST_F(ImportedTexture, uses_the_coordinates_that_the_material_names) {
  // The second set: the first one's corners, one further.
  std::string bytes = test::square_buffer();
  const std::array<float, 8> turned{1, 1, 1, 0, 0, 0, 0, 1};
  bytes.append(reinterpret_cast<const char*>(turned.data()), sizeof turned);
  json gltf = test::textured_square({{"uri", "four.png"}}, bytes);
  gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 92}, {"byteLength", 32}});
  gltf["accessors"].push_back(
      {{"bufferView", 3}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
  gltf["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = 3;
  gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
  const std::array<glm::vec3, 4> all = four(gltf_diffuse);
  expect_diffuse(import("t.gltf", gltf.dump()), {all[2], all[0], all[3], all[1]});
}

TEST_F(ImportedTexture, is_scaled_and_shifted_as_the_material_says) {
  json gltf = test::textured_square({{"uri", "four.png"}});
  gltf["extensionsUsed"] = {"KHR_texture_transform"};
  json& transform = gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
                        ["KHR_texture_transform"];
  const std::array<glm::vec3, 4> all = four(gltf_diffuse);
  transform = {{"offset", {0.5, 0}}};
  expect_diffuse(import("t.gltf", gltf.dump()), {all[1], all[0], all[3], all[2]});
  transform = {{"offset", {0, 0.5}}};
  expect_diffuse(import("t.gltf", gltf.dump()), {all[2], all[3], all[0], all[1]});
  transform = {{"offset", {0, 0.125}}, {"scale", {1, 0.5}}}; // v: 1/4 and 1/2
  const glm::vec3 left = (all[0] + all[2]) / 2.0F, right = (all[1] + all[3]) / 2.0F;
  expect_diffuse(import("t.gltf", gltf.dump()), {all[0], all[1], left, right});
}

// The extension's own example: the image's lower left quarter, turned clockwise by 90 degrees.
TEST_F(ImportedTexture, is_turned_as_the_material_says) {
  json gltf = test::textured_square({{"uri", "four.png"}});
  json& transform = gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
                        ["KHR_texture_transform"];
  const std::array<glm::vec3, 4> all = four(gltf_diffuse);
  // (u, v) becomes (v, 1 - u): what is seen at the top left has been at the bottom left.
  transform = {{"offset", {0, 1}}, {"rotation", 1.57079632679}};
  expect_diffuse(import("t.gltf", gltf.dump()), {all[2], all[0], all[3], all[1]});
}

TEST_F(ImportedTexture, of_a_specular_glossiness_material_multiplies_its_diffuse_part) {
  json gltf = test::textured_square({{"uri", "four.png"}});
  gltf["materials"][0].erase("pbrMetallicRoughness");
  gltf["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"]["diffuseTexture"] = {
      {"index", 0}};
  gltf["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
  json& parts = gltf["meshes"][0]["primitives"];
  parts.push_back(parts[0]);
  gltf["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"].update(
      {{"diffuseFactor", {0.5, 0.5, 1, 1}},
       {"specularFactor", {0.25, 0.5, 0.1}},
       {"glossinessFactor", 0.5}});
  const Scene scene = import("s.gltf", gltf.dump());
  EXPECT_EQ(notes_with(scene, "left out"), 0U);
  expect_diffuse(scene, four({0.25F, 0.25F, 0.5F}));
  for (const Material& material : quarters(scene)) {
    expect_near(std::get<CookTorrance>(material.lobe).f0, {0.25F, 0.5F, 0.1F});
    EXPECT_EQ(std::get<CookTorrance>(material.lobe).alpha, 0.25F);
  }
}

TEST_F(ImportedTexture, is_loaded_once_for_all_materials) {
  write(folder_.path / "two.mtl", "newmtl a\nKd 1 1 1\nmap_Kd four.png\n"
                                  "newmtl b\nKd 1 1 1\nmap_Kd ./four.png\n");
  const Scene scene = import("two.obj", "mtllib two.mtl\n" + square_obj + "usemtl a\n" +
                                            square_face + "usemtl b\nf 3/3 2/2 1/1\n");
  EXPECT_EQ(scene.surfaces.size(), 2U);
  EXPECT_EQ(scene.textures.size(), 1U);
  for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.texture.value().index, 0U);
}

TEST_F(ImportedTexture, that_is_missing_is_noted_once_and_the_factor_used) {
  write(folder_.path / "two.mtl", "newmtl a\nKd 1 0.5 0.25\nmap_Kd absent.png\n"
                                  "newmtl b\nKd 1 1 1\nmap_Kd absent.png\n");
  const Scene scene = import("two.obj", "mtllib two.mtl\n" + square_obj + "usemtl a\n" +
                                            square_face + "usemtl b\nf 3/3 2/2 1/1\n");
  EXPECT_EQ(notes_with(scene, "two.obj: texture 'absent.png' cannot be read: no such file: the "
                              "factor colour is used"),
            1U);
  EXPECT_EQ(notes_with(scene, "absent"), 1U);
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_TRUE(scene.mesh.uv.empty());
  EXPECT_EQ(quarters(scene)[1].diffuse, glm::vec3(1, 0.5F, 0.25F));
}

TEST_F(ImportedTexture, that_is_broken_is_noted_and_the_factor_used) {
  write_image("broken.png", test::four_colours().substr(0, 45));
  write_image("words.png", "not\nan image");
  for (const std::string name : {"broken.png", "words.png"}) {
    const Scene scene = import_square_gltf({{"uri", name}});
    EXPECT_EQ(notes_with(scene, "s.gltf: texture '" + name + "' cannot be read: "), 1U);
    EXPECT_EQ(notes_with(scene, "\n"), 0U);
    expect_diffuse(scene, {gltf_diffuse, gltf_diffuse, gltf_diffuse, gltf_diffuse});
  }
  const std::string uri = "data:image/png;base64," + test::base64("no image at all!!");
  const Scene scene = import_square_gltf({{"uri", uri}});
  EXPECT_EQ(notes_with(scene, "s.gltf: embedded texture 0 cannot be read: Not a PNG file"), 1U);
}

TEST_F(ImportedTexture, says_how_many_texels_are_out_of_the_domain) {
  write_image("a.exr", test::image_bytes<float>("exr", 2, 3, {-1, 2, 3, 1, 1, 1}));
  const Scene scene = import_square_obj("Kd 1 1 1\nmap_Kd a.exr\n");
  EXPECT_EQ(notes_with(scene, "texture 'a.exr' 1 texel negative or not finite: clamped"), 1U);
  expect_diffuse(scene, {glm::vec3(0, 2, 3), white, glm::vec3(0, 2, 3), white});
}

TEST_F(ImportedTexture, keeps_materials_in_their_domain_however_bright_it_is) {
  const float huge = 3e38F;
  write_image("a.exr", test::image_bytes<float>("exr", 1, 3, {huge, huge, huge}));
  const Scene scene = import_square_obj("Kd 8 8 8\nmap_Kd a.exr\n");
  EXPECT_EQ(quarters(scene)[0].diffuse, glm::vec3(std::numeric_limits<float>::max()));
}

TEST_F(ImportedTexture, is_left_out_on_meshes_without_coordinates_and_this_is_said) {
  write(folder_.path / "s.mtl", "newmtl paint\nKd 0.5 0.5 0.5\nmap_Kd four.png\n");
  const Scene scene = import("s.obj", "mtllib s.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                      "usemtl paint\nf 1 2 3 4\n");
  EXPECT_EQ(notes_with(scene, "a texture without texture coordinates on 1 mesh part: the factor"),
            1U);
  EXPECT_FALSE(scene.surfaces.at(0).texture);
  EXPECT_EQ(quarters(scene)[0].diffuse, glm::vec3(0.5F));
}

TEST_F(ImportedTexture, stays_on_those_of_a_materials_meshes_that_have_coordinates) {
  json gltf = test::textured_square({{"uri", "four.png"}});
  json& parts = gltf["meshes"][0]["primitives"];
  parts.push_back(parts[0]);
  parts[1]["attributes"].erase("TEXCOORD_0");
  const Scene scene = import("p.gltf", gltf.dump());
  ASSERT_EQ(scene.surfaces.size(), 2U);
  EXPECT_TRUE(scene.surfaces[scene.mesh.surface.at(0)].texture);
  EXPECT_FALSE(scene.surfaces[scene.mesh.surface.at(2)].texture);
  EXPECT_EQ(notes_with(scene, "without texture coordinates on 1 mesh part"), 1U);
}

TEST_F(ImportedTexture, goes_with_its_own_model_when_there_are_several) {
  write_image("grey.png", test::image_bytes<std::uint8_t>("png", 1, 1, {255}));
  write(folder_.path / "plain.obj", "v 0 0 -1\nv 1 0 -1\nv 1 1 -1\nf 1 2 3\n");
  write(folder_.path / "g.gltf", test::textured_square({{"uri", "grey.png"}}).dump());
  write(folder_.path / "f.gltf", test::textured_square({{"uri", "four.png"}}).dump());
  Scene scene;
  for (const char* name : {"plain.obj", "f.gltf", "plain.obj", "g.gltf", "plain.obj"}) {
    append_model(folder_.path / name, scene);
    // The one seen is the last square that lies in z = 0: moved away, others come to the front.
    if (std::string(name) == "f.gltf")
      for (glm::vec3& p : scene.mesh.positions) p.x += 10;
  }
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(scene.textures.size(), 2U);
  expect_diffuse(scene, {gltf_diffuse, gltf_diffuse, gltf_diffuse, gltf_diffuse});
  for (glm::vec3& p : scene.mesh.positions) p.x += p.x >= 10 ? -10 : 10;
  expect_diffuse(scene, four(gltf_diffuse));
}

TEST_F(ImportedTexture, is_refused_with_coordinates_that_are_not_finite) {
  std::string bytes = test::square_buffer();
  std::memcpy(&bytes[48 + 8], &nan, 4);
  write(folder_.path / "n.gltf", test::textured_square({{"uri", "four.png"}}, bytes).dump());
  expect_refusal("n.gltf: mesh 'square': texture coordinate 1 is not finite",
                 [&] { (void)import_model(folder_.path / "n.gltf"); });
}

} // namespace
} // namespace lightcuts
