// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/open_scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <variant>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kinds/light_kinds.h>
#include <lightcuts/render/io/scene_files.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/scene/bounds.h>
#include <lightcuts/render/scene/triangle.h>
#include <lightcuts/render/view/occluder.h>
#include <lightcuts/render/view/surface_material.h>
#include <nlohmann/json.hpp>

#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

using nlohmann::json;

/// tests/files: small scenes of one feature or fault each; expected.json says what each is read as.
const std::filesystem::path folder = LIGHTCUTS_TEST_FILES;

json expectations() { return json::parse(content_of(folder / "expected.json")); }

/// Few roundings of floats of about 1.
void expect_vector(const glm::dvec3& found, const json& expected, const std::string& what) {
  for (int i = 0; i < 3; ++i) {
    const double value = expected.at(i);
    EXPECT_NEAR(found[i], value, 1e-6 * std::max(1.0, std::abs(value))) << what << "[" << i << "]";
  }
}

void expect_notes(const Scene& scene, const json& expected) {
  const json parts = expected.value("notes", json::array());
  const auto holds = [](const std::string& note, const std::string& part) {
    return note.find(part) != std::string::npos;
  };
  for (const std::string part : parts)
    EXPECT_TRUE(std::ranges::any_of(scene.notes, [&](auto& note) { return holds(note, part); }))
        << "not noted: " << part;
  for (const std::string& note : scene.notes) {
    EXPECT_EQ(note.find('\n'), std::string::npos) << note;
    EXPECT_TRUE(
        holds(note, "no camera") ||
        std::ranges::any_of(parts, [&](const std::string part) { return holds(note, part); }))
        << "unexpected note: " << note;
  }
}

void expect_surfaces(const Scene& scene, const json& expected) {
  const auto each = [&](const char* key, const auto& check) {
    if (!expected.contains(key)) return;
    const json& values = expected.at(key);
    ASSERT_EQ(scene.surfaces.size(), values.size()) << key;
    for (std::size_t i = 0; i < values.size(); ++i) check(scene.surfaces[i], values[i]);
  };
  each("diffuse",
       [](const Surface& s, const json& v) { expect_vector(s.material.diffuse, v, "diffuse"); });
  each("f0", [](const Surface& s, const json& v) {
    expect_vector(std::get<CookTorrance>(s.material.lobe).f0, v, "f0");
  });
  each("alpha", [](const Surface& s, const json& v) {
    EXPECT_NEAR(std::get<CookTorrance>(s.material.lobe).alpha, v.get<double>(), 1e-6);
  });
  if (!expected.contains("glossy")) return;
  for (const Surface& s : scene.surfaces)
    EXPECT_EQ(s.material.is_glossy(), expected.at("glossy").get<bool>());
}

void expect_mesh(const Scene& scene, const json& expected) {
  const TriangleMesh& mesh = scene.mesh;
  if (expected.contains("box")) {
    const Box box = scene_bounds(mesh);
    expect_vector(box.lo, expected.at("box").at(0), "box.lo");
    expect_vector(box.hi, expected.at("box").at(1), "box.hi");
  }
  const auto expect_count = [&](const char* key, std::size_t found) {
    if (expected.contains(key)) {
      EXPECT_EQ(found, expected.at(key).get<std::size_t>()) << key;
    }
  };
  expect_count("triangles", mesh.triangles.size());
  expect_count("positions", mesh.positions.size());
  expect_count("surfaces", scene.surfaces.size());
  expect_count("lights", scene.lights.size());
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area += Triangle(mesh, t).area();
    if (expected.contains("faces_normals")) {
      EXPECT_GT(glm::dot(Triangle(mesh, t).normal(), glm::dvec3(mesh.normals[mesh.triangles[t].x])),
                0);
    }
    if (expected.contains("normal"))
      expect_vector(mesh.normals[mesh.triangles[t].x], expected.at("normal"), "normal");
  }
  if (expected.contains("area")) {
    EXPECT_NEAR(area, expected.at("area").get<double>(), 1e-6);
  }
}

std::optional<Hit> looked_up(const Occluder& occluder, const json& ray) {
  return occluder.intersect({ray.at(0), ray.at(1), ray.at(2)}, {ray.at(3), ray.at(4), ray.at(5)});
}

void expect_seen(const Scene& scene, const json& expected) {
  const Occluder occluder(scene.mesh);
  for (const json& seen : expected.value("seen", json::array())) {
    const auto hit = looked_up(occluder, seen.at("ray"));
    ASSERT_TRUE(hit) << seen;
    if (seen.contains("diffuse"))
      expect_vector(material_at(scene, *hit).diffuse, seen.at("diffuse"), seen.dump());
    if (seen.contains("emission"))
      expect_vector(emission_at(scene, *hit), seen.at("emission"), seen.dump());
  }
  const auto covers = [&](const json& place) {
    return looked_up(occluder, {place.at(0), place.at(1), 9, 0, 0, -1}).has_value();
  };
  for (const json& place : expected.value("covers", json::array())) EXPECT_TRUE(covers(place));
  for (const json& place : expected.value("leaves", json::array())) EXPECT_FALSE(covers(place));
}

void expect_lights(const Scene& scene, const json& expected) {
  const json spots = expected.value("spots", json::array());
  for (std::size_t i = 0; i < spots.size(); ++i) {
    ASSERT_LT(i, scene.lights.size());
    const auto degrees = [](float cosine) {
      return std::acos(double(cosine)) * 180 / std::numbers::pi;
    };
    // Cosines near 1 are rounded to multiples of 2^-24.
    EXPECT_NEAR(degrees(scene.lights[i].cos_inner), spots[i].at(0).get<double>(), 1e-3);
    EXPECT_NEAR(degrees(scene.lights[i].cos_outer), spots[i].at(1).get<double>(), 1e-3);
  }
  const json shines = expected.value("shines", json::array());
  for (std::size_t i = 0; i < shines.size(); ++i)
    expect_vector(-glm::dvec3(scene.lights[i].position), shines[i], "direction");
  // Light, direction, and what it sends there, W/sr.
  for (const json& sent : expected.value("sends", json::array())) {
    const Light& light = scene.lights[sent.at(0).get<std::size_t>()];
    const glm::vec3 way(sent.at(1), sent.at(2), sent.at(3));
    const double share = emission(light, light.position + way);
    expect_vector(share * glm::dvec3(light.intensity), {sent.at(4), sent.at(5), sent.at(6)},
                  sent.dump());
  }
  if (expected.contains("camera")) {
    const json& camera = expected.at("camera");
    expect_vector(scene.camera.position, camera, "camera");
    expect_vector(glm::normalize(glm::dvec3(scene.camera.target - scene.camera.position)),
                  json(std::vector<double>{camera.at(3), camera.at(4), camera.at(5)}), "view");
  }
}

/// The power of its area lights, few and many; a float each.
void expect_power(const Scene& scene, const json& expected) {
  if (!expected.contains("power")) return;
  for (const std::uint32_t count : {1U, 100U}) {
    Scene lit = scene;
    add_area_lights(lit, {.count = count});
    double power = 0;
    for (const Light& light : lit.lights)
      power += std::numbers::pi *
               (double(light.intensity.r) + light.intensity.g + light.intensity.b) / 3;
    EXPECT_NEAR(power, expected.at("power").get<double>(), 1e-6 * power) << count << " lights";
  }
}

void expect_refused(const std::string& file, const std::string& part) {
  try {
    (void)open_scene(file);
    ADD_FAILURE() << "not refused; expected: " << part;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nexpected in it: " << part;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(folder.string(), 0), 0U) << "does not begin with the file: " << message;
  }
}

void expect_read(const std::string& file, const json& expected, bool allow_outside) {
  const Scene scene = open_scene(file, allow_outside);
  if (!allow_outside) expect_notes(scene, expected);
  expect_surfaces(scene, expected);
  expect_mesh(scene, expected);
  expect_seen(scene, expected);
  expect_lights(scene, expected);
  expect_power(scene, expected);
}

TEST(FileCorpus, is_read_as_its_files_say) {
  for (const json& expected : expectations()) {
    SCOPED_TRACE(expected.at("file"));
    const std::string file = (folder / expected.at("file").get<std::string>()).string();
    try {
      if (expected.contains("refused"))
        expect_refused(file, expected.at("refused"));
      else
        expect_read(file, expected, false);
      if (expected.contains("outside")) expect_read(file, expected.at("outside"), true);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(FileCorpus, has_an_expectation_for_every_scene) {
  std::set<std::string> expected, helpers{"json/square.obj", "json/more/more.obj"};
  for (const json& e : expectations()) EXPECT_TRUE(expected.insert(e.at("file")).second) << e;
  EXPECT_GE(expected.size(), 60U);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && is_scene_file(entry.path()) && name != "expected.json" &&
        !helpers.contains(name)) {
      EXPECT_TRUE(expected.contains(name)) << name;
    }
  }
}

} // namespace
} // namespace lightcuts
