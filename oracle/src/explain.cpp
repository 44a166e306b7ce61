// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/explain.h>

#include <algorithm>

#include "each_view.h"
#include "explain_parts.h"

namespace lightcuts::oracle {
namespace {

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// In lines of at most 100 columns, if words are no longer.
std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > 0 && column + 1 + (end - at) > 100) {
      result += "\n  ";
      column = 2;
    } else if (at > 0) {
      result += " ";
      ++column;
    }
    result += text.substr(at, end - at);
    column += end - at;
    at = end + 1;
  }
  return result + "\n";
}

std::string head(const Subject& subject, const Counterexample& c) {
  const PropertyInfo& property = info(c.property);
  return fmt::format("{}\n  {}\n  {}\nsubject {}; {}, {}, {}; tree of seed {}\n", property.name,
                     property.statement, property.formula, subject.name(),
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
  std::string text;
  for_each_view(c.on, *reading.topology, lights, 0, [&](std::size_t i, const PointCase& at) {
    text = explain_cluster(judged, c.property, at);
    if (text.empty()) text = explain_cut(judged, c.property, c.on, at);
    if (text.empty()) return false;
    text = fmt::format("view {}\n{}\n", i, text_of(c.on.views[i].view)) + text;
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
