// SPDX-License-Identifier: MIT
#include <oracle/explain/explain.h>

#include <fmt/format.h>

#include <oracle/cases/case_text.h>
#include <oracle/explain/explain_parts.h>
#include <oracle/properties/each_view.h>

namespace lightcuts::oracle {
namespace {

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string head(const Subject& subject, const Counterexample& c) {
  const PropertyInfo& property = info(c.property);
  return fmt::format("{}\n", property.name) + wrapped(fmt::format("  {}", property.statement)) +
         wrapped(fmt::format("  {}", property.formula)) +
         fmt::format("subject {}; {}, {}, {}; tree of seed {}\n", subject.name(),
                     counted(c.on.lights.size(), "light"), counted(c.on.views.size(), "view"),
                     counted(c.on.triangles.size(), "triangle"), c.on.seed);
}

std::string steps(const Subject& subject, const Counterexample& c) {
  const LightSet lights = c.on.light_set();
  if (lights.empty()) return {};
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, c.on.seed);
  TreeClaim claim = tree->claim();
  if (std::string text = explain_tree(claim, lights, c.property); !text.empty()) return text;
  const TopologyReading reading = read_topology(std::move(claim), lights.size());
  const Judged judged{*tree, subject.parts()};
  Tally unused;
  const std::vector<glm::vec3> of_block =
      Judge(subject.parts(), 0, unused, c.property).block_bounds(judged, *reading.topology, c.on);
  std::vector<ShadingPoint> points;
  for (const CaseView& view : c.on.views) points.push_back(view.view.point());
  std::string text;
  for_each_view(c.on, *reading.topology, lights, 0, [&](std::size_t i, const PointCase& at) {
    const PointAnswers answers(judged, at);
    text = explain_cluster(answers, c.property);
    if (text.empty()) text = explain_block({answers, of_block, {0, 0}}, points, c.property);
    if (text.empty()) text = explain_cut(answers, c.property, c.on.cut);
    if (text.empty()) return false;
    text = fmt::format("view {}\n{}\n", i, lines_of(c.on.views[i].view)) + text;
    return true;
  });
  return text;
}

} // namespace

std::string explain(const Subject& subject, const Counterexample& counterexample) {
  std::string text = head(subject, counterexample);
  const auto failure = failure_of(subject, counterexample.property, counterexample.on);
  if (!failure) return text + "\nIt holds.\n\n" + text_of(counterexample.on);
  text += "\n" + wrapped("It does not hold: " + *failure) + "\n";
  std::string shown;
  try {
    shown = steps(subject, counterexample);
  } catch (const SubjectFailure& e) {
    text += fmt::format("Asked for the steps, the subject fails: {}\n\n", e.what());
  }
  return text + (shown.empty() ? text_of(counterexample.on) : shown);
}

} // namespace lightcuts::oracle
