// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/history_case.h>
#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {
namespace {

/// All that a tree answers at one point.
struct Answers {
  glm::vec3 radiance{0}, certified_error{0};
  std::vector<std::uint32_t> clusters;
  std::vector<glm::vec3> bounds;
  std::vector<DrawnLight> drawn;
};

class Questions {
public:
  Questions(const Subject& subject, const Case& on)
      : parts_(subject.parts()), on_(on), lights_(on.lights.size()) {}

  /// The cut first: bounds of all clusters would leave nothing of what was kept before.
  [[nodiscard]] Answers all(SubjectTree& tree, std::uint32_t nodes) const {
    const ShadingPoint point = on_.views.front().view.point();
    Answers answers;
    if (has(parts_, Part::cuts)) {
      const Cut cut = select(tree, point, {0, lights_, 0});
      answers.radiance = cut.radiance;
      answers.certified_error = cut.certified_error;
      for (const CutCluster& c : cut.clusters) answers.clusters.push_back(c.node);
    }
    if (has(parts_, Part::bounds)) {
      answers.bounds.resize(nodes);
      tree.bounds(point, answers.bounds);
    }
    if (has(parts_, Part::sampling))
      for (const double u : {0.1, 0.5, 0.9}) answers.drawn.push_back(tree.sample(0, point, u));
    return answers;
  }

  /// One question about many clusters, then so many about few, all of other views: what is kept of
  /// the first may be taken for new once a count of the others has come full circle.
  void others(SubjectTree& tree, std::uint32_t nodes, std::uint32_t count) const {
    const std::size_t others = on_.views.size() - 1;
    if (others == 0) return;
    for (std::uint32_t i = 0; i < count; ++i) {
      const ShadingPoint point = on_.views[others - i % others].view.point();
      if (has(parts_, Part::cuts)) {
        (void)select(tree, point, {0, i == 0 ? lights_ : 1, 0});
      } else if (has(parts_, Part::sampling)) {
        (void)tree.sample(0, point, 0.5);
      } else if (has(parts_, Part::bounds)) {
        std::vector<glm::vec3> bounds(nodes);
        tree.bounds(point, bounds);
      }
    }
  }

private:
  static Cut select(SubjectTree& tree, const ShadingPoint& point, const CutConfig& config) {
    return tree.select(point, config, [](std::uint32_t) { return true; });
  }

  Parts parts_;
  const Case& on_;
  std::uint32_t lights_;
};

/// As many other lights of the same kinds.
LightSet alike(const Case& on, std::uint32_t which) {
  LightSet set;
  for (std::uint32_t i = 0; i < on.lights.size(); ++i) {
    Light light = on.lights[i];
    if ((i + which) % 2 == 0) light.position = -light.position;
    set.add(light);
  }
  if (on.min_distance > 0) set.set_min_distance(on.min_distance);
  return set;
}

std::string difference_of(const Answers& old, const Answers& fresh) {
  if (old.radiance != fresh.radiance || old.certified_error != fresh.certified_error ||
      old.clusters != fresh.clusters)
    return fmt::format("exact cut has radiance {} where a new tree's has {}",
                       digits_of(old.radiance), digits_of(fresh.radiance));
  for (std::size_t i = 0; i < old.bounds.size() && i < fresh.bounds.size(); ++i)
    if (old.bounds[i] != fresh.bounds[i])
      return fmt::format("bound of node {} is {} where a new tree's is {}", i,
                         digits_of(old.bounds[i]), digits_of(fresh.bounds[i]));
  for (std::size_t i = 0; i < old.drawn.size(); ++i)
    if (old.drawn[i].light != fresh.drawn[i].light ||
        old.drawn[i].probability != fresh.drawn[i].probability)
      return fmt::format("light {} is drawn where a new tree draws {}", old.drawn[i].light,
                         fresh.drawn[i].light);
  return {};
}

void check_history(const HistoryCase& of, const Recorder& record) {
  const Case& on = of.on;
  const LightSet lights = on.light_set();
  const Questions questions(of.subject, on);
  const auto size_of = [](const SubjectTree& tree) {
    return std::uint32_t(tree.claim().nodes.size());
  };
  std::unique_ptr<SubjectTree> old;
  for (std::uint32_t i = 0; i < on.builds; ++i) {
    old = of.subject.build_after(std::move(old), alike(on, i), on.seed);
    (void)questions.all(*old, size_of(*old));
  }
  old = of.subject.build_after(std::move(old), lights, on.seed);
  const std::uint32_t nodes = size_of(*old);
  questions.others(*old, nodes, on.questions);
  const Answers aged = questions.all(*old, nodes);
  const auto fresh = of.subject.build(lights, on.seed);
  const std::string difference = difference_of(aged, questions.all(*fresh, size_of(*fresh)));
  record(difference.empty(), [&] {
    return fmt::format("after {} builds of as many other lights and {} questions at other points: "
                       "{}",
                       on.builds, on.questions, difference);
  });
}

} // namespace

const PropertyInfo property::history_is_immaterial{
    .name = "history-is-immaterial",
    .statement = "What was built and asked before does not change an answer.",
    .formula = "radiance, certified error, clusters, bounds, draws: the bits of a new tree",
    .of_history = check_history,
};

} // namespace lightcuts::oracle
