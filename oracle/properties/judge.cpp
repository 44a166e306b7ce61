// SPDX-License-Identifier: MIT
#include <oracle/properties/judge.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/cases/blocks.h>
#include <oracle/cases/random_pixels.h>
#include <oracle/properties/bounds/block_answers.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/each_view.h>
#include <oracle/properties/history_case.h>
#include <oracle/properties/invariance/invariance.h>
#include <oracle/properties/shading/picture_case.h>
#include <oracle/properties/shading/proof_case.h>
#include <oracle/properties/tree_case.h>

namespace lightcuts::oracle {
namespace {

/// The properties that have such a check.
template <auto of>
std::span<const Property> with() {
  static const std::vector<Property> list = [] {
    std::vector<Property> those;
    for (const Property p : all_properties)
      if (info(p).*of != nullptr) those.push_back(p);
    return those;
  }();
  return list;
}

// 10^-6 together with those of groups of lights; see draws-follow-probabilities.
constexpr DrawConfig draw_config{.false_alarms = 0.9e-6, .cases = most_cases_with_draws};

} // namespace

Judge::Judge(Parts parts, std::uint64_t place, Tally& tally, std::optional<Property> only)
    : parts_(parts), place_(place), tally_(tally),
      only_(only == Property::subject_answers ? std::nullopt : only) {}

bool Judge::wants(Property property) const {
  return (!only_ || *only_ == property) && (info(property).needs & ~parts_) == 0;
}

template <auto of>
bool Judge::any() const {
  const auto list = with<of>();
  return std::any_of(list.begin(), list.end(), [&](Property p) { return wants(p); });
}

template <auto of, class... Place>
void Judge::run(const Place&... place) const {
  for (const Property p : with<of>())
    if (wants(p)) (info(p).*of)(place..., record(p));
}

void Judge::subject(const Subject& subject) const { run<&PropertyInfo::of_subject>(subject); }

std::optional<Topology> Judge::tree(TreeClaim claim, const LightSet& lights) const {
  TopologyReading reading = read_topology(std::move(claim), lights.size());
  const Topology* topology = reading.topology ? &*reading.topology : nullptr;
  run<&PropertyInfo::of_tree>(TreeCase{lights, reading.defect, topology});
  return std::move(reading.topology);
}

void Judge::clusters(const PointAnswers& of, NodeRange nodes) const {
  if (has(Part::bounds)) run<&PropertyInfo::of_clusters>(of, nodes);
}

void Judge::cut(const PointAnswers& of, const CutConfig& config, const Cut& cut) const {
  run<&PropertyInfo::of_cut>(CutAnswer(of, config, cut));
}

void Judge::cuts(const PointAnswers& of, std::span<const CutConfig> configs) const {
  if (!has(Part::cuts) || !any<&PropertyInfo::of_cut>()) return;
  for (const CutConfig& config : configs) cut(of, config, of.select(config));
}

void Judge::point(const PointAnswers& of, const CutConfig& config) const {
  run<&PropertyInfo::of_point>(of, config);
}

void Judge::odds(const PointAnswers& of) const {
  if (!has(Part::sampling) || !any<&PropertyInfo::of_odds>()) return;
  for (std::uint32_t node = 0; node < of.topology().size(); ++node)
    run<&PropertyInfo::of_odds>(ClusterOdds(of, node));
}

void Judge::few_odds(const PointAnswers& of) const {
  if (!has(Part::sampling) || !any<&PropertyInfo::of_odds>()) return;
  constexpr std::uint32_t nodes = 64, lights = 64;
  constexpr std::size_t not_too_many = 2'000; // as many questions; most large cases have more
  if (of.at.lights().size() <= not_too_many) run<&PropertyInfo::of_odds>(ClusterOdds(of, 0));
  std::uint32_t asked = 0;
  for (std::uint32_t node = of.topology().size(); node-- > 0 && asked < nodes;) {
    if (of.topology().light_count(node) > lights) continue;
    run<&PropertyInfo::of_odds>(ClusterOdds(of, node));
    ++asked;
  }
}

void Judge::draws(const PointAnswers& of, const CutConfig& cut, const DrawConfig& config) const {
  if (!any<&PropertyInfo::of_draws>()) return;
  if (const Draws draws(of, cut, config); draws.count() > 0) run<&PropertyInfo::of_draws>(draws);
}

void Judge::light(const ShadingPoint& point, const Light& light) const {
  run<&PropertyInfo::of_light>(point, light);
}

void Judge::lobe(const Lobe& lobe) const { run<&PropertyInfo::of_lobe>(lobe); }

void Judge::ray(const RayCase& of) const { run<&PropertyInfo::of_ray>(of); }

void Judge::proofs(const Subject& subject, const SceneView& view, const LightTree& tree,
                   std::span<const VisiblePoint> points, std::uint64_t most) const {
  if (!any<&PropertyInfo::of_proof>()) return;
  const std::vector<ProvenSight> sights = subject.prove(view, tree, points);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> proven; // node, light
  std::vector<std::uint32_t> open;
  for (std::uint32_t node = 0; node < sights.size(); ++node) {
    if (sights[node] == ProvenSight::unknown) continue;
    for (open.assign(1, node); !open.empty();) {
      const TreeNode& cluster = tree.node(open.back());
      open.pop_back();
      if (cluster.is_leaf()) {
        proven.emplace_back(node, cluster.representative);
      } else {
        open.push_back(cluster.first_child + 1);
        open.push_back(cluster.first_child);
      }
    }
  }
  const std::uint64_t pairs = proven.size() * points.size();
  for (std::uint64_t i = 0; i < std::min(pairs, most); ++i) {
    const std::uint64_t pair = pairs <= most ? i : hashed(place_, i) % pairs;
    const auto [node, light] = proven[pair / points.size()];
    run<&PropertyInfo::of_proof>(
        ProofCase{view, points[pair % points.size()], light, node, sights[node]});
  }
}

void Judge::picture(const Subject& subject, const Case& on) const {
  const bool pixels = has(Part::pictures) && any<&PropertyInfo::of_picture>();
  const bool rays = any<&PropertyInfo::of_ray>(), proven = any<&PropertyInfo::of_proof>();
  if (on.triangles.empty() || (!pixels && !rays && !proven)) return;
  const Scene scene = on.scene();
  const SceneView view(scene);
  if (pixels) run<&PropertyInfo::of_picture>(PictureCase(subject, on, view));
  if ((!rays && !proven) || scene.lights.empty()) return;
  std::vector<VisiblePoint> points;
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x)
      if (const auto p = view.at({x, y})) points.push_back(*p);
  constexpr auto every = std::numeric_limits<std::uint64_t>::max();
  if (proven) proofs(subject, view, build(scene.lights, {on.seed}), points, every);
  RayCount count;
  for (const VisiblePoint& p : points)
    for (std::uint32_t i = 0; rays && i < scene.lights.size(); ++i)
      ray({subject, view, p, i, count});
}

void Judge::invariance(const Subject& subject, const Case& on) const {
  if (on.views.empty() || on.lights.empty() || !any<&PropertyInfo::of_invariance>()) return;
  run<&PropertyInfo::of_invariance>(Invariance(subject, on));
}

void Judge::history(const Subject& subject, const Case& on) const {
  const bool asked = on.questions > 0 && on.views.size() > 1;
  if (on.lights.empty() || on.views.empty() || (!asked && on.builds == 0)) return;
  run<&PropertyInfo::of_history>(HistoryCase{subject, on});
}

std::vector<glm::vec3> Judge::block_bounds(const Judged& judged, const Topology& topology,
                                           const Case& on) const {
  std::vector<glm::vec3> bounds;
  if (!any<&PropertyInfo::of_block>() || !is_block(on)) return bounds;
  std::vector<ShadingPoint> points;
  for (const CaseView& view : on.views) points.push_back(view.view.point());
  bounds.resize(topology.size());
  judged.tree.block_bounds(points, bounds);
  return bounds;
}

void Judge::block(const BlockAnswers& of) const { run<&PropertyInfo::of_block>(of); }

void Judge::block(const Judged& judged, const Topology& topology, const LightSet& lights,
                  const Case& on) const {
  const std::vector<glm::vec3> bounds = block_bounds(judged, topology, on);
  if (bounds.empty()) return;
  for_each_view(on, topology, lights, place_, [&](std::size_t, const PointCase& at) {
    block({PointAnswers(judged, at), bounds, {0, topology.size()}});
    return false;
  });
}

void Judge::views(const Judged& judged, const Topology& topology, const LightSet& lights,
                  const Case& on) const {
  if (!any<&PropertyInfo::of_clusters>() && !any<&PropertyInfo::of_block>() &&
      !any<&PropertyInfo::of_cut>() && !any<&PropertyInfo::of_odds>() &&
      !any<&PropertyInfo::of_point>() && !any<&PropertyInfo::of_draws>())
    return;
  const std::vector<glm::vec3> of_block = block_bounds(judged, topology, on);
  for_each_view(on, topology, lights, place_, [&](std::size_t, const PointCase& at) {
    const PointAnswers answers(judged, at);
    clusters(answers);
    if (!of_block.empty()) block({answers, of_block, {0, topology.size()}});
    const auto configs = cuts_of(on.cut, on.lights.size());
    if (on.lights.size() > many_lights) {
      cuts(answers, std::array{configs[0], configs[2]});
      few_odds(answers);
      return false;
    }
    cuts(answers, configs);
    odds(answers);
    point(answers, on.cut);
    if (on.draws) draws(answers, on.cut, draw_config);
    return false;
  });
}

void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally,
                std::optional<Property> only) {
  const Judge judge(subject.parts(), place, tally, only);
  judge.answers([&] {
    judge.picture(subject, on);
    judge.subject(subject);
    const LightSet lights = on.light_set();
    if (lights.empty()) return;
    const std::unique_ptr<SubjectTree> tree = subject.build(lights, on.seed);
    const std::optional<Topology> topology = judge.tree(tree->claim(), lights);
    if (!topology) return;
    judge.views({*tree, subject.parts()}, *topology, lights, on);
    if (lights.size() > many_lights) return;
    judge.invariance(subject, on);
    judge.history(subject, on);
  });
}

} // namespace lightcuts::oracle
