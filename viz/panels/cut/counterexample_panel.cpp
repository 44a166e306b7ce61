// SPDX-License-Identifier: MIT
#include <viz/panels/cut/counterexample_panel.h>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/panels/gui/drawing.h>
#include <viz/panels/gui/gui.h>

namespace lightcuts::viz {
namespace {

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

/// Exact enough to tell neighbours apart.
std::string digits(double v) { return fmt::format("{:.9g}", v); }

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void draw_sides(Workbench& workbench) {
  const OpenedCounterexample& c = *workbench.scene()->counterexample();
  if (!c.node) return;
  if (ImGui::Button(fmt::format("node {}", *c.node).c_str())) workbench.state.node = c.node;
  tooltip("The first cluster on which the property does not hold: select it.");
  if (!ImGui::BeginTable("sides", 4, ImGuiTableFlags_Borders | ImGuiTableFlags_SizingFixedFit))
    return;
  for (const char* head : {"", "red", "green", "blue"}) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  const auto row = [](const char* name, const glm::dvec3& v) {
    cell(name);
    for (int i = 0; i < 3; ++i) cell(digits(v[i]));
  };
  row("subject's bound", glm::dvec3(c.bound));
  row("true contribution, all seen", c.open_truth);
  row("subject's estimate", c.estimate);
  row("true contribution", c.seen_truth);
  ImGui::EndTable();
}

} // namespace

void draw_counterexample_panel(Workbench& workbench) {
  const OpenedCounterexample& c = *workbench.scene()->counterexample();
  const oracle::PropertyInfo& property = info(c.saved.counterexample.property);
  ImGui::TextUnformatted(property.name);
  ImGui::SameLine();
  if (c.still_fails)
    ImGui::TextColored(violation_text, "does not hold for %s", c.saved.subject.c_str());
  else
    ImGui::Text("holds for %s", c.saved.subject.c_str());
  wrapped(property.statement);
  ImGui::PushStyleColor(ImGuiCol_Text, quiet_text);
  wrapped(property.formula);
  ImGui::PopStyleColor();
  if (c.still_fails) wrapped(c.message);
  draw_sides(workbench);
  ImGui::Separator();
  ImGui::BeginChild("steps", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
  push_fixed_width();
  ImGui::TextUnformatted(c.explanation.c_str());
  ImGui::PopFont();
  ImGui::EndChild();
}

} // namespace lightcuts::viz
