// SPDX-License-Identifier: MIT
#include <viz/panels/cut/refinement_panel.h>

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <lightcuts/render/files/text.h>

#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>
#include <viz/panels/plots/plot.h>

namespace lightcuts::viz {
namespace {

void slider(Workbench& workbench, const Inspection& inspection) {
  const int last = int(inspection.final_size);
  int step =
      int(std::min(workbench.state.step.value_or(inspection.final_size), inspection.final_size));
  const auto set = [&](int to) {
    to = std::clamp(to, 1, last);
    workbench.state.step = to == last ? std::nullopt : std::optional(std::uint32_t(to));
  };
  if (ImGui::ArrowButton("##back", ImGuiDir_Left)) set(step - 1);
  ImGui::SameLine();
  if (ImGui::ArrowButton("##on", ImGuiDir_Right)) set(step + 1);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 8 * ImGui::GetFontSize());
  const char* format = last > 1 ? "%d clusters" : "1 cluster";
  if (ImGui::SliderInt("of the cut", &step, 1, std::max(last, 1), format)) set(step);
  tooltip("Refinement starts at the root and replaces, again and again, the cluster of the largest "
          "relative bound by its children. The icicle, the table and the scene show the cut as it "
          "was at this step.");
}

const char* ending(const Inspection& inspection) {
  switch (inspection.end) {
  case CutEnd::converged:
    return "every bound is within the threshold";
  case CutEnd::black_level:
    return "every bound is within the threshold or the black level";
  case CutEnd::max_size:
    return "the largest size was reached";
  }
  return "";
}

double total(const glm::vec3& v) { return double(v.x) + v.y + v.z; }

void state_of_cut(Workbench& workbench, const Inspection& inspection) {
  ImGui::Text("total %s, certified error %s", short_text(float(total(inspection.radiance))).c_str(),
              short_text(float(total(inspection.certified_error))).c_str());
  if (inspection.refined_next) {
    ImGui::Text("refined next: node %u", *inspection.refined_next);
    ImGui::SameLine();
    if (ImGui::SmallButton("select")) workbench.state.node = inspection.refined_next;
  } else if (inspection.clusters.size() == inspection.final_size) {
    ImGui::TextColored(quiet_text, "ended: %s", ending(inspection));
  }
}

/// The clusters with the largest bounds relative to the total: the heap's top.
void heap(Workbench& workbench, const Inspection& inspection) {
  std::vector<const ClusterRow*> rows;
  for (const ClusterRow& row : inspection.clusters)
    if (row.share > 0) rows.push_back(&row);
  const auto shown = std::min<std::size_t>(rows.size(), 5);
  std::partial_sort(rows.begin(), rows.begin() + std::ptrdiff_t(shown), rows.end(),
                    [](const auto* a, const auto* b) { return a->share > b->share; });
  ImGui::TextUnformatted(
      fmt::format("heap: {}, these the largest", counted(rows.size(), "cluster")).c_str());
  for (std::size_t i = 0; i < shown; ++i) {
    const bool selected = workbench.state.node == rows[i]->node;
    const auto text =
        fmt::format("node {}: {}, {} of the threshold##heap{}", rows[i]->node,
                    counted(rows[i]->lights, "light"), short_text(float(rows[i]->share)), i);
    if (ImGui::Selectable(text.c_str(), selected)) workbench.state.node = rows[i]->node;
  }
}

void curve(const RefinementCurve& c, const Inspection& inspection) {
  if (c.size.size() < 2) return;
  Plot plot;
  plot.x_label = "clusters";
  plot.y_label = "radiance";
  plot.x_logarithmic = plot.y_logarithmic = true;
  plot.series = {{"total", c.size, c.total, {}, PlotKind::line},
                 {"certified error", c.size, c.certified, {}, PlotKind::line},
                 {"largest bound", c.size, c.largest_bound, {}, PlotKind::line},
                 {"this step", {double(inspection.clusters.size())}, {0}, {}, PlotKind::vertical}};
  ImVec2 size = ImGui::GetContentRegionAvail();
  size.y = std::max(size.y, 120.0F);
  draw_plot("refinement", plot, size);
}

} // namespace

void draw_refinement_panel(Workbench& workbench) {
  const auto& result = workbench.inspection();
  if (!result || !result->inspection.sees_surface) {
    ImGui::TextColored(quiet_text, "Click a pixel of a surface first.");
    return;
  }
  const Inspection& inspection = result->inspection;
  slider(workbench, inspection);
  state_of_cut(workbench, inspection);
  heap(workbench, inspection);
  curve(result->curve, inspection);
}

} // namespace lightcuts::viz
