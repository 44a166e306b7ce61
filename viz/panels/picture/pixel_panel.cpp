// SPDX-License-Identifier: MIT
#include <viz/panels/picture/pixel_panel.h>

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <lightcuts/render/files/text.h>
#include <oracle/records/record_text.h>

#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

void text(const std::string& line) { ImGui::TextWrapped("%s", line.c_str()); }
/// On one line as far as they fit: no number is parted.
void in_one_line(const std::vector<std::string>& parts) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float between = 2 * ImGui::CalcTextSize(" ").x;
  bool first = true;
  for (const std::string& part : parts) {
    const float width = ImGui::CalcTextSize(part.c_str()).x;
    if (!first && ImGui::GetItemRectMax().x + between + width <= right) ImGui::SameLine(0, between);
    ImGui::TextUnformatted(part.c_str());
    first = false;
  }
}
void quiet(const std::string& line) {
  ImGui::PushTextWrapPos();
  ImGui::TextColored(quiet_text, "%s", line.c_str());
  ImGui::PopTextWrapPos();
}

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

const char* ending(CutEnd end) {
  switch (end) {
  case CutEnd::converged:
    return "all bounds obey the threshold";
  case CutEnd::black_level:
    return "ended by the black level";
  case CutEnd::max_size:
    return "ended by the maximum size";
  }
  return "";
}

/// An error summed over RGB, and relative as the layers have it.
std::string error_text(const Inspection& i, double error, const glm::dvec3& of) {
  const double least = 3 * double(i.config.black_level);
  const double relative = error == 0 ? 0 : error / std::max(sum(of), least);
  return fmt::format("{} ({} %)", short_text(error), short_text(100 * relative));
}

void radiance(const Inspection& i) {
  in_one_line({"radiance " + rgb_text(glm::dvec3(i.radiance)),
               "certified error " +
                   error_text(i, sum(glm::dvec3(i.certified_error)), glm::dvec3(i.radiance))});
  if (!i.truth) {
    quiet("truth ... (every light is being looked at)");
    return;
  }
  const double error = sum(glm::abs(glm::dvec3(i.radiance) - *i.truth));
  in_one_line({"truth " + rgb_text(*i.truth), "true error " + error_text(i, error, *i.truth)});
}

void cut(Workbench& workbench, const Inspection& i) {
  if (workbench.sources(workbench.state.display, layers::image).frame->sums_all_lights())
    quiet("the picture sums all lights; by the tree it would be:");
  std::string line = fmt::format("cut {} of {} lights, {} shadow rays", i.clusters.size(),
                                 workbench.scene()->scene().lights.size(), i.shadow_rays);
  if (i.clairvoyant) line += fmt::format(", clairvoyant {}", *i.clairvoyant);
  text(line);
  tooltip("The clairvoyant cut is the smallest whose true errors are all within the threshold.");
  quiet(fmt::format("{}; threshold {:g} %",
                    i.clusters.size() < i.final_size
                        ? fmt::format("step {} of {}", i.clusters.size(), i.final_size)
                        : std::string(ending(i.end)),
                    100 * double(i.config.threshold)));
}

void cluster(Workbench& workbench) {
  const auto row = workbench.selected_row();
  if (!row) {
    quiet("no cluster selected: click one in the tree, the table or the scene");
    return;
  }
  ImGui::TextColored(
      ImGui::ColorConvertU32ToFloat4(selection_colour), "%s",
      fmt::format("node {}: {}, depth {}", row->node, counted(row->lights, "light"), row->depth)
          .c_str());
  ImGui::SameLine();
  quiet(row->visible ? "its representative is seen" : "its representative is hidden");
  std::vector<std::string> parts{"bound " + rgb_text(glm::dvec3(row->bound)),
                                 "estimate " + rgb_text(row->estimate)};
  if (row->truth) parts.push_back("truth " + rgb_text(*row->truth));
  in_one_line(parts);
}

} // namespace

void draw_pixel_panel(Workbench& workbench) {
  const ViewState& s = workbench.state;
  if (!s.pixel) {
    quiet("Click a pixel: its cut is shown here.");
    return;
  }
  const auto& result = workbench.inspection();
  if (!result) {
    quiet("...");
    return;
  }
  const Inspection& i = result->inspection;
  if (workbench.scene()->counterexample())
    text("the counterexample's shading point");
  else
    text(fmt::format("pixel {}, {}", s.pixel->x, s.pixel->y));
  ImGui::SameLine();
  if (!result->failure.empty()) {
    ImGui::TextColored(violation_text, "%s", result->failure.c_str());
    return;
  }
  if (!i.sees_surface) {
    quiet("sees no surface");
    return;
  }
  quiet(fmt::format("at {:.4g} {:.4g} {:.4g}, lobe {}", i.position.x, i.position.y, i.position.z,
                    oracle::text_of(i.material.lobe)));
  radiance(i);
  cut(workbench, i);
  cluster(workbench);
}

} // namespace lightcuts::viz
