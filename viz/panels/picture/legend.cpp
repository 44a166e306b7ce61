// SPDX-License-Identifier: MIT
#include <viz/panels/picture/legend.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/model/layers/histogram.h>
#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

constexpr int bins = 64;

double bar_width() { return 1.15 * double(ImGui::GetFontSize()); }
double histogram_width() { return 2.4 * double(ImGui::GetFontSize()); }

ImU32 packed(const Rgb8& c) { return IM_COL32(c.r, c.g, c.b, 255); }

/// Of the values of pixels that see a surface, as shares of the most frequent bin.
std::vector<float> bars_of(const LayerValues& layer, const HeatMapScale& scale) {
  std::vector<float> values;
  for (std::size_t i = 0; i < layer.values.size(); ++i)
    if (layer.known[i] != 0 && layer.surface[i] != 0) values.push_back(layer.values[i]);
  const Histogram histogram = histogram_of(values, {scale.lo, scale.hi, bins, scale.logarithmic});
  const auto most = double(std::max<std::uint64_t>(
      1, *std::max_element(histogram.counts.begin(), histogram.counts.end())));
  std::vector<float> bars;
  for (const std::uint64_t count : histogram.counts) bars.push_back(float(double(count) / most));
  return bars;
}

} // namespace

void Legend::draw(Workbench& workbench, const ShownPicture& shown) {
  const Layer layer = workbench.state.layer;
  const Coloured& coloured = shown.coloured();
  if (layer.is_image()) {
    draw_exposure(workbench, coloured);
    return;
  }
  const float line = ImGui::GetTextLineHeight();
  ImGui::TextUnformatted(layer->unit[0] != 0 ? layer->unit : "value");
  tooltip(layer->meaning);
  origin_ = to_dvec(ImGui::GetCursorScreenPos()) + glm::dvec2(0, 0.5 * line);
  size_ = {bar_width(), std::max(8.0, double(ImGui::GetContentRegionAvail().y) - 1.2 * line)};
  ImGui::InvisibleButton("bar", {float(bar_width() + histogram_width()), float(size_.y)});
  drag_range(workbench, coloured);
  if (!ImGui::IsItemActive())
    tooltip("Drag the upper half to move the upper end of the range, the lower half to move the "
            "lower one. A double click shows all again.");
  draw_bar(workbench.state.colours.map);
  draw_histogram(shown);
  draw_numbers(layer, coloured);
}

void Legend::draw_bar(ColourMap map) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (int i = 0; i < bins; ++i) {
    const double top = origin_.y + size_.y * (1 - double(i + 1) / bins);
    const double bottom = origin_.y + size_.y * (1 - double(i) / bins);
    list->AddRectFilled({float(origin_.x), float(top)},
                        {float(origin_.x + bar_width()), float(bottom) + 0.5F},
                        packed(heat_colour((float(i) + 0.5F) / bins, {}, map)));
  }
}

void Legend::draw_histogram(const ShownPicture& shown) {
  const HeatMapScale& scale = shown.coloured().scale;
  if (bars_version_ != shown.version() || !(scale == bars_scale_)) {
    bars_version_ = shown.version();
    bars_scale_ = scale;
    bars_ = bars_of(shown.values(), scale);
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double left = origin_.x + bar_width() + 3;
  for (int i = 0; i < bins; ++i) {
    if (bars_[std::size_t(i)] <= 0) continue;
    const double top = origin_.y + size_.y * (1 - double(i + 1) / bins);
    const double length = std::max(1.0, (histogram_width() - 4) * std::sqrt(bars_[std::size_t(i)]));
    list->AddRectFilled({float(left), float(top)},
                        {float(left + length), float(top + size_.y / bins)},
                        IM_COL32(150, 152, 165, 255));
  }
}

void Legend::draw_numbers(Layer layer, const Coloured& coloured) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const HeatMapScale& scale = coloured.scale;
  const float x = float(origin_.x + bar_width() + histogram_width() + 4);
  for (const double tick : nice_ticks(scale.lo, scale.hi, 7, scale.logarithmic)) {
    if (layer->whole_numbers && tick != std::floor(tick)) continue;
    const float y = float(origin_.y + size_.y * (1 - fraction_of(float(tick), scale)));
    list->AddLine({float(origin_.x + bar_width()), y}, {float(origin_.x + bar_width()) + 4, y},
                  IM_COL32(230, 230, 235, 255));
    list->AddText({x, y - ImGui::GetTextLineHeight() / 2}, IM_COL32(220, 220, 228, 255),
                  short_text(float(tick)).c_str());
  }
}

void Legend::drag_range(Workbench& workbench, const Coloured& coloured) {
  ColourSettings& colours = workbench.state.colours;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    colours.automatic_range = true;
    return;
  }
  if (ImGui::IsItemActivated()) drags_top_ = io.MousePos.y < origin_.y + 0.5 * size_.y;
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(0, 3) || io.MouseDelta.y == 0) return;
  HeatMapScale scale = coloured.scale;
  // As if the bar's colours were moved by the mouse: by shares of the range.
  const double by = io.MouseDelta.y / size_.y;
  const auto moved = [&](float end) {
    if (scale.logarithmic) return float(end * std::pow(double(scale.hi) / scale.lo, by));
    return float(end + by * (double(scale.hi) - scale.lo));
  };
  (drags_top_ ? scale.hi : scale.lo) = moved(drags_top_ ? scale.hi : scale.lo);
  if (!(scale.lo < scale.hi)) return;
  colours.automatic_range = false;
  colours.lo = scale.lo;
  colours.hi = scale.hi;
}

void Legend::draw_exposure(Workbench& workbench, const Coloured& coloured) const {
  ColourSettings& colours = workbench.state.colours;
  ImGui::TextUnformatted("stops");
  tooltip("Exposure, powers of two. A double click takes the automatic one again, which maps the "
          "95th percentile of luminance to 0.9 of white.");
  float stops = std::log2(coloured.exposure);
  const float height = std::max(40.0F, ImGui::GetContentRegionAvail().y - 4);
  ImGui::PushID("exposure");
  if (ImGui::VSliderFloat("##stops", {1.6F * ImGui::GetFontSize(), height}, &stops, -20, 20, "", 0))
    colours.exposure = std::exp2(stops);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) colours.exposure.reset();
  tooltip(fmt::format("exposure {:.3g} = 2^{:.2f}", coloured.exposure, stops).c_str());
  ImGui::PopID();
}

} // namespace lightcuts::viz
