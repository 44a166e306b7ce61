// SPDX-License-Identifier: MIT
#include <oracle/truth/brute_force_occlusion.h>

#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

struct Randomness {
  explicit Randomness(unsigned seed) : engine(seed) {}
  std::mt19937 engine;

  float operator()(float lo, float hi) {
    return std::uniform_real_distribution<float>(lo, hi)(engine);
  }
  unsigned below(std::size_t n) {
    return std::uniform_int_distribution<unsigned>(0, static_cast<unsigned>(n) - 1)(engine);
  }
  glm::vec3 vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
};

void add(TriangleMesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.surface.push_back(0);
}

TriangleMesh soup(Randomness& random, float triangle_size) {
  TriangleMesh mesh;
  for (int i = 0; i < 30; ++i) {
    const glm::vec3 centre = random.vector();
    add(mesh, centre + triangle_size * random.vector(), centre + triangle_size * random.vector(),
        centre + triangle_size * random.vector());
  }
  return mesh;
}

// Sizes from 2^-20 to 1, in clumps around the vertices of earlier triangles.
TriangleMesh clumps(Randomness& random) {
  TriangleMesh mesh;
  for (int i = 0; i < 40; ++i) {
    const float size = std::exp2(random(-20, 0));
    const glm::vec3 at = mesh.positions.empty() || random(0, 1) < 0.1F
                             ? random.vector()
                             : mesh.positions[random.below(mesh.positions.size())];
    add(mesh, at, at + size * random.vector(), at + size * random.vector());
  }
  return mesh;
}

// Axis-aligned boxes on a coarse grid, so that faces touch and coincide.
TriangleMesh boxes(Randomness& random) {
  TriangleMesh mesh;
  const auto grid = [&] { return static_cast<float>(random.below(9)) / 4 - 1; };
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 p(grid(), grid(), grid()), q(grid(), grid(), grid());
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {p[axis], q[axis]}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<glm::vec3, 4> c{p, p, q, q};
        for (glm::vec3& corner : c) corner[axis] = side;
        c[1][u] = q[u], c[1][v] = p[v], c[3][u] = p[u], c[3][v] = q[v];
        add(mesh, c[0], c[1], c[2]);
        add(mesh, c[0], c[2], c[3]);
      }
  }
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, float scale, const glm::vec3& offset) {
  for (glm::vec3& p : mesh.positions) p = scale * (p + offset);
  return mesh;
}

// A point of a triangle: inside, on an edge, or a vertex.
glm::vec3 point_of(const TriangleMesh& mesh, Randomness& random, unsigned vertices) {
  const glm::uvec3 t = mesh.triangles[random.below(mesh.triangles.size())];
  glm::vec3 sum(0);
  float total = 0;
  for (unsigned k = 0; k < vertices; ++k) {
    const float weight = random(0.01F, 1);
    sum += weight * mesh.positions[t[static_cast<int>(k)]], total += weight;
  }
  return vertices == 1 ? mesh.positions[t.x] : sum / total;
}

glm::vec3 anywhere(const TriangleMesh& mesh, Randomness& random) {
  const glm::vec3 p = point_of(mesh, random, 3), q = point_of(mesh, random, 3);
  const auto distance = static_cast<float>(glm::distance(glm::dvec3(p), glm::dvec3(q)));
  return p + 2 * distance * random.vector();
}

struct Tally {
  int clear = 0, blocked = 0, undecided = 0, disagreements = 0;

  void count(Occlusion truth, bool occluded) {
    if (truth == Occlusion::undecided) ++undecided;
    if (truth == Occlusion::clear) ++clear, disagreements += occluded ? 1 : 0;
    if (truth == Occlusion::blocked) ++blocked, disagreements += occluded ? 0 : 1;
  }
  double undecided_share() const {
    return static_cast<double>(undecided) / (clear + blocked + undecided);
  }
};

// Rays between random points; `aim`: how many vertices the target is a mix of, 0 for anywhere.
void compare(const TriangleMesh& mesh, Randomness& random, int rays, unsigned aim, Tally& tally) {
  const Occluder occluder(mesh);
  for (int i = 0; i < rays; ++i) {
    const glm::vec3 from = anywhere(mesh, random);
    const glm::vec3 to = aim > 0 ? point_of(mesh, random, aim) : anywhere(mesh, random);
    ShadowRay ray = shadow_ray(from, to);
    if (aim > 0) ray.far = random(0.5F, 2);
    tally.count(brute_force_occlusion(mesh, ray), occluder.occluded(ray));
  }
}

template <typename Make>
Tally compare_many(unsigned seed, unsigned aim, Make make) {
  Randomness random(seed);
  Tally tally;
  for (int i = 0; i < 100; ++i) compare(make(random), random, 400, aim, tally);
  EXPECT_EQ(tally.disagreements, 0);
  EXPECT_GT(tally.clear, 1000);
  EXPECT_GT(tally.blocked, 1000);
  return tally;
}

void expect_generic(const Tally& tally) { EXPECT_LT(tally.undecided_share(), 0.01); }

TEST(BruteForceOcclusion, agrees_with_embree_on_soups) {
  expect_generic(compare_many(1, 0, [](Randomness& r) { return soup(r, 0.4F); }));
}

TEST(BruteForceOcclusion, agrees_with_embree_on_clumps_of_any_size) {
  // Of a triangle 2^-20 times as large as its distance single precision knows little.
  EXPECT_LT(compare_many(2, 0, clumps).undecided_share(), 0.5);
}

TEST(BruteForceOcclusion, agrees_with_embree_on_boxes) {
  expect_generic(compare_many(3, 0, boxes));
}

TEST(BruteForceOcclusion, agrees_with_embree_at_any_scale) {
  expect_generic(compare_many(4, 0, [](Randomness& random) {
    return moved(soup(random, 0.4F), std::exp2(random(-110, 110)), glm::vec3(0));
  }));
}

TEST(BruteForceOcclusion, agrees_with_embree_far_from_the_origin) {
  expect_generic(
      compare_many(5, 0, [](Randomness& r) { return moved(soup(r, 0.4F), 1, 1e6F * r.vector()); }));
}

TEST(BruteForceOcclusion, agrees_with_embree_on_rays_at_vertices_edges_and_faces) {
  for (const unsigned aim : {1U, 2U, 3U}) {
    const Tally in_soup = compare_many(6 + aim, aim, [](Randomness& r) { return soup(r, 0.4F); });
    compare_many(10 + aim, aim, boxes);
    compare_many(14 + aim, aim, clumps);
    if (aim == 3) expect_generic(in_soup);
  }
}

TEST(BruteForceOcclusion, notices_a_missing_triangle) {
  Randomness random(20);
  Tally tally;
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = soup(random, 0.4F);
    TriangleMesh incomplete = mesh;
    incomplete.triangles.pop_back();
    const Occluder occluder(incomplete);
    for (int k = 0; k < 200; ++k) {
      const ShadowRay ray = shadow_ray(anywhere(mesh, random), anywhere(mesh, random));
      tally.count(brute_force_occlusion(mesh, ray), occluder.occluded(ray));
    }
  }
  EXPECT_GT(tally.disagreements, 10);
}

TEST(BruteForceOcclusion, notices_a_ray_that_is_too_long_or_too_short) {
  for (const float error : {1 + 1e-3F, 1 - 1e-3F}) {
    Randomness random(21);
    Tally tally;
    const TriangleMesh mesh = soup(random, 0.4F);
    const Occluder occluder(mesh);
    for (int k = 0; k < 50000; ++k) {
      ShadowRay ray = shadow_ray(anywhere(mesh, random), anywhere(mesh, random));
      const Occlusion truth = brute_force_occlusion(mesh, ray);
      ray.far *= error;
      tally.count(truth, occluder.occluded(ray));
    }
    EXPECT_GT(tally.disagreements, 0) << error;
  }
}

TEST(BruteForceOcclusion, is_undecided_on_an_edge_and_certain_beside_it) {
  TriangleMesh mesh;
  add(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto at = [&](float x, float y, float from, float to) {
    return brute_force_occlusion(mesh, shadow_ray({x, y, from}, {x, y, to}));
  };
  EXPECT_EQ(at(0.5F, 0, 1, -1), Occlusion::undecided);
  EXPECT_EQ(at(0.5F, 1e-5F, 1, -1), Occlusion::blocked);
  EXPECT_EQ(at(0.5F, -1e-5F, 1, -1), Occlusion::clear);
  EXPECT_EQ(at(0.25F, 0.25F, 0, -1), Occlusion::undecided);
  EXPECT_EQ(at(0.25F, 0.25F, 1, 0), Occlusion::clear);
  EXPECT_EQ(at(0.25F, 0.25F, 1e-4F, -1), Occlusion::blocked);
  EXPECT_EQ(at(0.25F, 0.25F, -1e-4F, -1), Occlusion::clear);
}

TEST(BruteForceOcclusion, finds_nothing_in_nothing) {
  EXPECT_EQ(brute_force_occlusion({}, shadow_ray({0, 0, 0}, {1, 0, 0})), Occlusion::clear);
}

TEST(BruteForceOcclusion, never_calls_a_triangle_without_area_blocking) {
  TriangleMesh mesh;
  add(mesh, {0, 0, 0}, {1, 1, 0}, {2, 2, 0});
  EXPECT_NE(brute_force_occlusion(mesh, shadow_ray({0.5F, 0.5F, 1}, {0.5F, 0.5F, -1})),
            Occlusion::blocked);
}

} // namespace
} // namespace lightcuts
