// SPDX-License-Identifier: MIT
#include <viz/panels/app/status_line.h>

#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

std::string if_any(std::uint64_t n, const char* what) {
  return n == 0 ? std::string() : fmt::format("  {} {}", n, what);
}

} // namespace

void draw_status(Workbench& workbench, const ImagePanel& image) {
  const LayerStatistics& n = image.shown().coloured().statistics;
  const auto picture = workbench.current_picture();
  if (picture || !image.raster_complete()) {
    const float share = picture ? float(picture->share()) : image.raster_share();
    const auto left = picture ? picture->seconds_left() : std::nullopt;
    const std::string text =
        fmt::format("{:.0f} %{}", 100 * share, left ? ", " + duration_text(*left) + " left" : "");
    ImGui::ProgressBar(share, {ImGui::GetFontSize() * 14, ImGui::GetTextLineHeight() + 2},
                       text.c_str());
    ImGui::SameLine();
  } else {
    const auto frame = workbench.sources(workbench.state.display, layers::image).frame;
    if (frame->complete() && !workbench.state.display.is_raster()) {
      ImGui::Text("rendered in %s", duration_text(frame->seconds()).c_str());
      ImGui::SameLine();
    }
    const auto features = frame->features();
    if (features && !features->tree) {
      ImGui::TextColored(quiet_text, "no tree here: it would not pay");
      tooltip("Live: 'use the tree even where it does not pay' shows the cuts that lightcuts would "
              "make.");
      ImGui::SameLine();
    }
  }
  const Layer layer = workbench.state.layer;
  const bool clean = !picture && n.known > 0 && n.largest == 0;
  if (layer->none != nullptr && clean)
    ImGui::TextUnformatted(fmt::format("{} at {} pixels", layer->none, n.known).c_str());
  else if (!layer.is_image())
    ImGui::TextUnformatted(
        fmt::format("mean {}  largest {}", short_text(n.mean), short_text(n.largest)).c_str());
  else
    ImGui::TextUnformatted("");
  const std::string odd = if_any(n.nan, "NaN (magenta)") + if_any(n.infinite, "infinite (cyan)");
  if (!odd.empty()) {
    ImGui::SameLine();
    ImGui::TextColored(violation_text, "%s", odd.c_str());
  }
}

} // namespace lightcuts::viz
