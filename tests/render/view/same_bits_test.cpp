// SPDX-License-Identifier: MIT
// Whatever is built, cut or rendered keeps its bits from one version to the next and from one
// compiler to the other: hashes of it, compared with tests/render/view/same_bits.csv. Where a
// change of bits is wanted, LIGHTCUTS_WRITE_HASHES=1 writes that table anew.
#include <lightcuts/render/view/renderer.h>

#include <bit>
#include <cstdlib>
#include <fstream>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/view/scene_features.h>

namespace lightcuts {
namespace {

/// FNV-1a over the bits of what is added, 64 bits at a time.
class Hash {
public:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void add(Number x) {
    if constexpr (std::is_same_v<Number, float>)
      mix(std::bit_cast<std::uint32_t>(x));
    else if constexpr (std::is_same_v<Number, double>)
      mix(std::bit_cast<std::uint64_t>(x));
    else
      mix(std::uint64_t(x));
  }
  template <class T>
  void add(const glm::tvec3<T>& v) {
    for (int c = 0; c < 3; ++c) add(v[c]);
  }
  void add(const Box& box) {
    add(box.lo);
    add(box.hi);
  }
  void add(CutEnd end) { add(int(end)); }
  template <class T>
  void add(const std::vector<T>& values) {
    for (const T& value : values) add(value);
  }

  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

private:
  void mix(std::uint64_t bits) { state_ = (state_ ^ bits) * 0x100000001b3U; }

  std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// By "scene,part".
using Hashes = std::map<std::string, std::string>;

std::string hash_of(const LightTree& tree) {
  Hash hash;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const TreeNode& node = tree.node(i);
    hash.add(node.box);
    hash.add(node.intensity);
    for (const std::uint32_t part : {node.first_child, node.representative, node.light_count})
      hash.add(part);
    hash.add(node.kinds);
    const ClusterMoments& moments = tree.moments(i);
    for (const glm::vec3& v : {moments.centroid, moments.variance, moments.covariance}) hash.add(v);
    if ((tree.lights().kinds() & kinds_with_axis) == 0) continue;
    const ClusterEmission& emission = tree.emission(i);
    for (const glm::vec3& v :
         {emission.cone.axis, emission.mean_axis, emission.axis_square, emission.axis_product})
      hash.add(v);
    for (const float v : {emission.cone.chord2, emission.cos_inner, emission.cos_outer})
      hash.add(v);
  }
  return hash.text();
}

void add(Hash& hash, const Cut& cut) {
  for (const CutCluster& cluster : cut.clusters) {
    hash.add(cluster.node);
    hash.add(cluster.visible);
    hash.add(cluster.estimate);
    hash.add(cluster.bound);
  }
  hash.add(cut.radiance);
  hash.add(cut.certified_error);
  hash.add(cut.shadow_rays);
  hash.add(cut.end);
}

/// Cuts of all pixels.
std::string hash_of_cuts(const SceneView& view, const LightTree& tree, CutConfig config) {
  config.unoccluded = !view.may_occlude();
  CutSelector select(tree, config);
  Hash hash;
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x)
      if (const auto p = view.at({x, y}))
        add(hash, select(p->point, [&](std::uint32_t light) { return view.sees(*p, light); }));
  return hash.text();
}

/// All but the times.
std::string hash_of(const Rendering& r) {
  Hash hash;
  hash.add(r.radiance);
  hash.add(r.certified_error);
  hash.add(r.emission);
  hash.add(r.cut_size);
  hash.add(r.shadow_rays);
  hash.add(r.end);
  hash.add(r.surface_pixels);
  return hash.text();
}

std::string hash_of(const SceneFeatures& features) {
  Hash hash;
  for (const bool need : {features.clamp, features.specular, features.occlusion, features.tree})
    hash.add(need);
  for (const double measured : {features.pilot_cut_size, features.pilot_cost_of_cuts})
    hash.add(measured);
  hash.add(features.kinds);
  hash.add(features.black_level);
  return hash.text();
}

/// The cloud in all its variety, and the scenes without parameters.
std::vector<std::string> scenes() {
  std::vector<std::string> specs;
  for (const BuiltinScene& scene : builtin_scenes())
    if (scene.name != "cloud") specs.push_back(scene.name);
  for (const char* kind : {"omni", "oriented", "spot", "directional", "profile", "mixed"})
    for (const char* material : {"diffuse", "phong", "ward", "ggx"})
      for (const char* clamp : {"", "&clamp=0.7"})
        for (const int blocks : {0, 20})
          specs.push_back(fmt::format("cloud?lights=300&blocks={}&kind={}&material={}{}", blocks,
                                      kind, material, clamp));
  return specs;
}

void hash_cuts(const std::string& spec, const SceneView& view, const LightTree& tree,
               Hashes& hashes) {
  for (const CutConfig& config :
       {CutConfig{0.3F}, CutConfig{0.02F}, CutConfig{0, 40}, CutConfig{0.01F, 1000, 0.01F}})
    hashes[fmt::format("{},cuts by {:g} {} {:g}", spec, config.threshold, config.max_size,
                       config.black_level)] = hash_of_cuts(view, tree, config);
}

void hash_pictures(const std::string& spec, const SceneView& view, const LightTree& tree,
                   Hashes& hashes) {
  for (const Method method : all_methods)
    for (const bool specialise : {true, false})
      hashes[fmt::format("{},{} by the {} kernel", spec, method->name,
                         specialise ? "narrowest" : "general")] =
          hash_of(
              render(view, tree, {.method = method, .cut = {0.1F, 100}, .specialise = specialise}));
}

Hashes computed() {
  Hashes hashes;
  for (const std::string& spec : scenes()) {
    Scene scene = make_builtin(spec);
    scene.image_size = {8, 5};
    const SceneView view(scene);
    for (const Builder builder : all_builders)
      hashes[fmt::format("{},{} tree", spec, name_of(builder))] =
          hash_of(build(scene.lights, {.builder = builder}));
    const LightTree tree = build(scene.lights);
    hashes[spec + ",features"] = hash_of(find_scene_features(view, tree, {}));
    hash_cuts(spec, view, tree, hashes);
    hash_pictures(spec, view, tree, hashes);
  }
  return hashes;
}

Hashes committed() {
  Hashes hashes;
  std::ifstream file(LIGHTCUTS_SAME_BITS);
  for (std::string line; std::getline(file, line);) {
    const std::size_t comma = line.rfind(',');
    hashes[line.substr(0, comma)] = line.substr(comma + 1);
  }
  return hashes;
}

void write(const Hashes& hashes) {
  std::ofstream file(LIGHTCUTS_SAME_BITS);
  for (const auto& [part, hash] : hashes) file << part << ',' << hash << '\n';
}

TEST(SameBits, AreThoseOfTheCommittedTable) {
  const Hashes hashes = computed();
  if (std::getenv("LIGHTCUTS_WRITE_HASHES") != nullptr) write(hashes);
  const Hashes expected = committed();
  for (const auto& [part, hash] : hashes)
    if (!expected.contains(part))
      ADD_FAILURE() << part << " is " << hash << ", and not in the table";
    else
      EXPECT_EQ(hash, expected.at(part)) << part;
  EXPECT_EQ(hashes.size(), expected.size()) << "the table has lines of what there is no more";
}

} // namespace
} // namespace lightcuts
