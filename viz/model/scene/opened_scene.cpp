// SPDX-License-Identifier: MIT
#include <viz/model/scene/opened_scene.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/counterexamples/named_subjects.h>
#include <oracle/explain/explain.h>
#include <oracle/explain/failing_place.h>
#include <oracle/subjects/library_subject.h>
#include <viz/model/scene/counterexample_scene.h>

namespace lightcuts::viz {
namespace {

/// By what it says of itself; what cannot be read is left to whoever reads scenes to complain of.
bool is_counterexample(const std::filesystem::path& file) {
  if (file.extension() != ".json") return false;
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("schema") || !json["schema"].is_string()) return false;
  return json["schema"].get<std::string>().starts_with("lightcuts-oracle/counterexample/");
}

/// As the command line opens it, but not without light.
Scene lit_scene(const SceneRequest& request, const Progress& progress) {
  Scene scene = open_scene(request, 0, progress);
  if (!scene.lights.empty()) return scene;
  generate(default_cloud(scene.mesh, lights_for_dark_scenes, request.seed), scene.lights);
  scene.notes.push_back(fmt::format("has no lights: lit by {} random ones in its upper half",
                                    lights_for_dark_scenes));
  return scene;
}

std::vector<std::uint32_t> depths(const oracle::Topology& topology) {
  std::vector<std::uint32_t> depth(topology.size(), 0);
  for (const std::uint32_t node : topology.parents_first())
    for (const std::uint32_t child : topology.children(node)) depth[child] = depth[node] + 1;
  return depth;
}

} // namespace

OpenedScene::OpenedScene(SceneRequest request, const Progress& progress)
    : request_(std::move(request)) {
  if (is_counterexample(request_.spec))
    open_counterexample();
  else
    scene_ = lit_scene(request_, progress);
  progress.leave_if_cancelled();
  view_ = std::make_unique<SceneView>(scene_);
  progress.leave_if_cancelled();
  build_tree(progress);
  progress.leave_if_cancelled();
  if (counterexample_ && counterexample_->node) judge_counterexample();
  depth_ = depths(topology_);
  progress.leave_if_cancelled();
  if (counterexample_) {
    default_threshold_ = counterexample_->cut.threshold;
    black_level_ = counterexample_->cut.black_level;
  } else {
    default_threshold_ = lightcuts::default_threshold(*view_);
    features_ = find_scene_features(*view_, *tree_, {default_threshold_, default_max_cut, 0});
    black_level_ = features_.black_level;
  }
}

void OpenedScene::open_counterexample() {
  OpenedCounterexample opened{oracle::load_counterexample(request_.spec)};
  const oracle::Counterexample& c = opened.saved.counterexample;
  opened.cut = c.on.cut;
  if (c.on.views.empty() || c.on.lights.empty())
    throw InputError(InputFault::missing, request_.spec +
                                              ": has no shading point or no light to look at; "
                                              "'lightcuts-oracle replay' shows its arithmetic");
  subject_ = oracle::subject_named(opened.saved.subject);
  try {
    if (const auto failure = oracle::failure_of(*subject_, c.property, c.on)) {
      opened.still_fails = true;
      opened.message = *failure;
    }
    opened.explanation = oracle::explain(*subject_, c);
    if (const auto place = oracle::failing_place(*subject_, c)) {
      opened.view = place->view;
      opened.node = place->node;
      opened.cut = place->cut;
    }
  } catch (const oracle::SubjectFailure& failure) {
    opened.still_fails = true;
    opened.message = failure.what();
  }
  scene_ = scene_of_case(c.on, opened.view);
  scene_.name = std::filesystem::path(request_.spec).stem().string();
  counterexample_ = std::move(opened);
}

oracle::Parts OpenedScene::parts() const {
  return subject_ ? subject_->parts() : oracle::all_parts_and_claims;
}

void OpenedScene::judge_counterexample() {
  OpenedCounterexample& c = *counterexample_;
  const oracle::CaseView& view = c.saved.counterexample.on.views[c.view];
  const ShadingPoint point = view.view.point();
  std::vector<char> visible(scene_.lights.size(), 1);
  for (const std::uint32_t light : view.hidden) visible[light] = 0;
  oracle::Truth truth;
  truth.evaluate(topology_, scene_.lights, point, visible);
  const oracle::Judged judged{*subject_tree_, subject_->parts()};
  c.bound = subject_tree_->bound(*c.node, point);
  if (judged.has(oracle::Part::estimates))
    c.estimate = seen_estimate(judged, *c.node, {0, point, visible, truth}, c.bound);
  for (int i = 0; i < 3; ++i) {
    c.open_truth[i] = double(truth.open(*c.node)[std::size_t(i)]);
    c.seen_truth[i] = double(truth.seen(*c.node)[std::size_t(i)]);
  }
}

void OpenedScene::build_tree(const Progress& progress) {
  const auto start = Clock::now();
  std::uint64_t seed = request_.tree_seed;
  Builder builder = request_.builder;
  if (counterexample_) {
    seed = counterexample_->saved.counterexample.on.seed;
    // One of the library's subjects has the name of its builder.
    builder = value_named<Builder>(counterexample_->saved.subject).value_or(Builder::greedy);
  }
  tree_ = std::make_shared<const LightTree>(build(scene_.lights, {seed, builder, progress}));
  build_seconds_ = seconds_since(start);
  oracle::TreeClaim claim;
  if (counterexample_) {
    subject_tree_ = subject_->build(scene_.lights, seed);
    claim = subject_tree_->claim();
  } else {
    claim = oracle::claim_of(*tree_);
  }
  oracle::TopologyReading reading = oracle::read_topology(std::move(claim), scene_.lights.size());
  if (!reading.topology)
    throw InputError(InputFault::inconsistent, fmt::format("{}: the subject's tree is none: {}",
                                                           request_.spec, reading.defect));
  topology_ = std::move(*reading.topology);
}

} // namespace lightcuts::viz
