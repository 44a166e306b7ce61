// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bound.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <lightcuts/render/builtin/builtin_scenes.h>
#include <oracle/cases/random_pixels.h>
#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {
namespace {

constexpr std::array kinds{"omni", "oriented", "spot", "directional", "profile"};
constexpr std::array materials{"diffuse", "phong", "ward", "ggx"};
constexpr std::uint32_t point_count = 200;

/// One line of the table: bound over true contribution of clusters of 2 to 64 lights.
struct Tightness {
  std::string scene; ///< kind and material
  std::size_t cases = 0;
  double median = 0, p95 = 0; ///< to the third decimal
};

double uniform(std::uint64_t seed, std::uint64_t index, double lo, double hi) {
  return lo + (hi - lo) * double(hashed(seed, index) >> 11) * 0x1p-53;
}

/// Anywhere below the lights, facing anywhere towards the camera.
ShadingPoint point_of(const Scene& scene, std::uint64_t i) {
  const glm::vec3 position(uniform(1, i, -3.9, 3.9), uniform(2, i, 0, 1.9),
                           uniform(3, i, -3.9, 3.9));
  const glm::dvec3 v = glm::normalize(glm::dvec3(scene.camera.position) - glm::dvec3(position));
  const double z = uniform(4, i, -1, 1), angle = uniform(5, i, 0, 2 * std::numbers::pi);
  const double ring = std::sqrt(1 - z * z);
  glm::dvec3 n(ring * std::cos(angle), z, ring * std::sin(angle));
  if (glm::dot(n, v) < 0) n = -n;
  return {position, glm::vec3(n), glm::vec3(v), scene.surfaces.front().material};
}

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return std::round(1000 * *at) / 1000;
}

Tightness measure(const std::string& kind, const std::string& material) {
  const Scene scene =
      make_builtin("cloud?lights=2000&blocks=0&kind=" + kind + "&material=" + material);
  const LightTree tree = build(scene.lights);
  LibraryTree library(tree);
  const Topology topology = read_topology(claim_of(tree), scene.lights.size()).topology.value();
  const std::vector<char> visible(scene.lights.size(), 1);
  Truth truth;
  std::vector<double> slacks;
  for (std::uint64_t i = 0; i < point_count; ++i) {
    const ShadingPoint point = point_of(scene, i);
    truth.evaluate(topology, scene.lights, point, visible);
    for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
      const std::uint32_t size = tree.node(node).light_count;
      const Wide& open = truth.open(node);
      const auto sum = double(open[0] + open[1] + open[2]);
      if (size < 2 || size > 64 || sum <= 0) continue;
      const glm::dvec3 bound(library.bound(node, point));
      slacks.push_back((bound.x + bound.y + bound.z) / sum);
    }
  }
  return {kind + "," + material, slacks.size(), quantile(slacks, 0.5), quantile(slacks, 0.95)};
}

std::string csv_of(const std::vector<Tightness>& table) {
  std::string text = "kind,material,cases,median,p95\n";
  for (const Tightness& t : table)
    text += fmt::format("{},{},{:.3f},{:.3f}\n", t.scene, t.cases, t.median, t.p95);
  return text;
}

std::vector<Tightness> committed() {
  std::vector<Tightness> table;
  std::ifstream file(LIGHTCUTS_TIGHTNESS);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    Tightness t;
    std::istringstream fields(line);
    std::string kind, material, cases, median, p95;
    for (std::string* field : {&kind, &material, &cases, &median, &p95})
      std::getline(fields, *field, ',');
    table.push_back({kind + "," + material, std::stoul(cases), std::stod(median), std::stod(p95)});
  }
  return table;
}

/// One unit of the last digit may be rounding; 1 % less is a reason to commit the new table.
void expect_tightness(const char* what, double measured, double expected) {
  EXPECT_LE(measured, expected + 0.0015) << what << ": the bounds became looser";
  EXPECT_GE(measured, 0.99 * expected - 0.0015)
      << what << ": tighter; commit the table with LIGHTCUTS_WRITE_TIGHTNESS=1";
}

// The table is tests/oracle/properties/tightness.csv; LIGHTCUTS_WRITE_TIGHTNESS=1 writes it anew.
TEST(Tightness, IsThatOfTheCommittedTable) {
  std::vector<Tightness> table;
  for (const char* kind : kinds)
    for (const char* material : materials) table.push_back(measure(kind, material));
  std::cout << csv_of(table);
  if (std::getenv("LIGHTCUTS_WRITE_TIGHTNESS") != nullptr)
    std::ofstream(LIGHTCUTS_TIGHTNESS) << csv_of(table);
  const std::vector<Tightness> expected = committed();
  ASSERT_EQ(table.size(), expected.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    SCOPED_TRACE(table[i].scene);
    EXPECT_EQ(table[i].scene, expected[i].scene);
    EXPECT_EQ(table[i].cases, expected[i].cases);
    expect_tightness("median", table[i].median, expected[i].median);
    expect_tightness("95th percentile", table[i].p95, expected[i].p95);
  }
}

} // namespace
} // namespace lightcuts::oracle
