// SPDX-License-Identifier: MIT
#include <viz/panels/plots/plot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <viz/model/layers/value_text.h>

namespace lightcuts::viz {
namespace {

constexpr ImU32 plot_ground = IM_COL32(22, 24, 28, 255), frame = IM_COL32(140, 144, 150, 255);
constexpr ImU32 grid = IM_COL32(255, 255, 255, 22), text_colour = IM_COL32(200, 203, 208, 255);
constexpr float gap = 5; // between text and what it belongs to, pixels

/// Colours that the colour-blind can tell apart. See Okabe and Ito, "Color Universal Design".
ImU32 colour_of(std::size_t series, int alpha = 255) {
  constexpr std::array<std::array<int, 3>, 6> palette{{{86, 180, 233},
                                                       {230, 159, 0},
                                                       {0, 190, 140},
                                                       {240, 228, 66},
                                                       {225, 110, 30},
                                                       {214, 139, 181}}};
  const auto& c = palette[series % palette.size()];
  return IM_COL32(c[0], c[1], c[2], alpha);
}

/// From values to pixels.
struct Axis {
  bool logarithmic;
  double lo = INFINITY, hi = -INFINITY; ///< values
  float first = 0, last = 0;            ///< their pixels

  [[nodiscard]] bool shows(double v) const { return std::isfinite(v) && (!logarithmic || v > 0); }
  void include(double v) {
    if (!shows(v)) return;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  [[nodiscard]] double scaled(double v) const { return logarithmic ? std::log(v) : v; }
  [[nodiscard]] float pixel(double v) const {
    const double share = (scaled(v) - scaled(lo)) / (scaled(hi) - scaled(lo));
    return float(first + share * (last - first));
  }
  /// Some room at both ends, but not below 0 where all values are above.
  void pad(double share) {
    if (!(lo <= hi)) {
      lo = logarithmic ? 1 : 0;
      hi = logarithmic ? 10 : 1;
    } else if (logarithmic) {
      const double room = lo == hi ? 2 : std::pow(hi / lo, share);
      lo /= room;
      hi *= room;
    } else {
      const double room = lo == hi ? std::max(0.5 * std::abs(lo), 0.5) : share * (hi - lo);
      lo = lo >= 0 && lo < room ? 0 : lo - room;
      hi += room;
    }
  }
  [[nodiscard]] std::vector<double> ticks(float pixels_each) const {
    const float room = std::abs(last - first) / pixels_each;
    return nice_ticks(lo, hi, std::uint32_t(std::max(room, 2.0F)), logarithmic);
  }
};

struct PlotCanvas {
  ImDrawList* draw;
  ImVec2 lo, hi; ///< of the area within the axes, pixels
  Axis x, y;

  [[nodiscard]] ImVec2 at(double vx, double vy) const { return {x.pixel(vx), y.pixel(vy)}; }
};

/// Values that a series has.
std::size_t count(const PlotSeries& s) {
  return s.kind == PlotKind::vertical ? s.x.size() : std::min(s.x.size(), s.y.size());
}

/// Where bar i begins and bar i - 1 ends: halfway between the two, as the axis has it.
double border(const PlotSeries& s, std::size_t i, const Axis& axis) {
  const auto scaled = [&](std::size_t k) { return axis.scaled(s.x[k]); };
  const std::size_t last = s.x.size() - 1;
  double at = 0;
  if (last == 0)
    at = scaled(0) + (i == 0 ? -0.5 : 0.5);
  else if (i == 0)
    at = 1.5 * scaled(0) - 0.5 * scaled(1);
  else if (i > last)
    at = 1.5 * scaled(last) - 0.5 * scaled(last - 1);
  else
    at = 0.5 * (scaled(i - 1) + scaled(i));
  return axis.logarithmic ? std::exp(at) : at;
}

void include(const PlotSeries& s, Axis& x, Axis& y) {
  for (std::size_t i = 0; i < count(s); ++i) {
    x.include(s.x[i]);
    if (s.kind != PlotKind::vertical) y.include(s.y[i]);
  }
  if (s.kind != PlotKind::bars || s.x.empty()) return;
  x.include(border(s, 0, x));
  x.include(border(s, s.x.size(), x));
  // A bar stands on 0, or on half of the smallest one where there is no 0.
  y.include(y.logarithmic ? y.lo / 2 : 0);
}

PlotCanvas canvas_of(const Plot& plot, ImVec2 origin, ImVec2 size) {
  PlotCanvas c{ImGui::GetWindowDrawList(), {}, {}, {plot.x_logarithmic}, {plot.y_logarithmic}};
  bool bars = false;
  for (const PlotSeries& s : plot.series) {
    include(s, c.x, c.y);
    bars = bars || s.kind == PlotKind::bars;
  }
  c.x.pad(bars ? 0 : 0.03);
  c.y.pad(0.06);
  const float line = ImGui::GetTextLineHeight(), wide = ImGui::CalcTextSize("-1.234e-5").x;
  c.lo = {origin.x + wide + gap, origin.y + line + gap};
  c.hi = {origin.x + size.x - wide / 2, origin.y + size.y - 2 * line - 2 * gap};
  c.hi = {std::max(c.hi.x, c.lo.x + 1), std::max(c.hi.y, c.lo.y + 1)};
  std::tie(c.x.first, c.x.last, c.y.first, c.y.last) = std::tuple(c.lo.x, c.hi.x, c.hi.y, c.lo.y);
  return c;
}

void draw_text(const PlotCanvas& c, ImVec2 at, const std::string& what, float align_x) {
  const float width = ImGui::CalcTextSize(what.c_str()).x;
  c.draw->AddText({at.x - align_x * width, at.y}, text_colour, what.c_str());
}

void draw_axes(const Plot& plot, const PlotCanvas& c) {
  const float line = ImGui::GetTextLineHeight();
  for (const double tick : c.x.ticks(70)) {
    const float x = c.x.pixel(tick);
    c.draw->AddLine({x, c.lo.y}, {x, c.hi.y}, grid);
    draw_text(c, {x, c.hi.y + gap}, short_text(tick), 0.5F);
  }
  for (const double tick : c.y.ticks(35)) {
    const float y = c.y.pixel(tick);
    c.draw->AddLine({c.lo.x, y}, {c.hi.x, y}, grid);
    draw_text(c, {c.lo.x - gap, y - line / 2}, short_text(tick), 1);
  }
  c.draw->AddRect(c.lo, c.hi, frame);
  draw_text(c, {(c.lo.x + c.hi.x) / 2, c.hi.y + line + 1.5F * gap}, plot.x_label, 0.5F);
  draw_text(c, {c.lo.x, c.lo.y - line - gap / 2}, plot.y_label, 0);
}

/// Pixels from which to which a bar goes.
ImVec2 span_of_bar(const PlotSeries& s, std::size_t i, const Axis& axis) {
  return {axis.pixel(border(s, i, axis)), axis.pixel(border(s, i + 1, axis))};
}

void draw_bar(const PlotSeries& s, std::size_t i, std::size_t index, const PlotCanvas& c) {
  if (!c.x.shows(s.x[i]) || !c.y.shows(s.y[i])) return;
  const ImVec2 span = span_of_bar(s, i, c.x);
  const float space = span.y - span.x > 4 ? 1.0F : 0.0F;
  c.draw->AddRectFilled({span.x, c.y.pixel(s.y[i])}, {span.y - space, c.hi.y},
                        colour_of(index, 200));
}

void draw_value(const PlotSeries& s, std::size_t i, std::size_t index, const PlotCanvas& c) {
  if (s.kind == PlotKind::bars) return draw_bar(s, i, index, c);
  if (!c.x.shows(s.x[i])) return;
  if (s.kind == PlotKind::vertical) {
    const float x = c.x.pixel(s.x[i]);
    c.draw->AddLine({x, c.lo.y}, {x, c.hi.y}, colour_of(index), 1.5F);
    return;
  }
  if (!c.y.shows(s.y[i])) return;
  const bool is_line = s.kind == PlotKind::line;
  if (!is_line || i < s.labels.size())
    c.draw->AddCircleFilled(c.at(s.x[i], s.y[i]), 3.5F, colour_of(index));
  if (is_line && i > 0 && c.x.shows(s.x[i - 1]) && c.y.shows(s.y[i - 1]))
    c.draw->AddLine(c.at(s.x[i - 1], s.y[i - 1]), c.at(s.x[i], s.y[i]), colour_of(index), 2);
}

/// Above the plot, from the right as far as there is room beside the label of y.
void draw_legend(const Plot& plot, const PlotCanvas& c) {
  const float line = ImGui::GetTextLineHeight();
  const float y = c.lo.y - line - gap / 2;
  const float least = c.lo.x + ImGui::CalcTextSize(plot.y_label.c_str()).x + 2 * gap;
  float x = c.hi.x;
  for (std::size_t k = plot.series.size(); k-- > 0;) {
    const std::string& name = plot.series[k].name;
    if (name.empty()) continue;
    x -= ImGui::CalcTextSize(name.c_str()).x;
    if (x - line < least) return;
    draw_text(c, {x, y}, name, 0);
    x -= line;
    c.draw->AddRectFilled({x, y + 0.3F * line}, {x + 0.8F * line, y + 0.7F * line}, colour_of(k));
    x -= 2 * gap;
  }
}

/// Pixels from the mouse to a value.
float distance(const PlotSeries& s, std::size_t i, const PlotCanvas& c, ImVec2 mouse) {
  if (!c.x.shows(s.x[i])) return INFINITY;
  const float dx = c.x.pixel(s.x[i]) - mouse.x;
  if (s.kind == PlotKind::vertical) return std::abs(dx) + 1; // a point on it comes first
  if (s.kind == PlotKind::bars) {
    const ImVec2 span = span_of_bar(s, i, c.x);
    return mouse.x >= span.x && mouse.x < span.y ? 10.0F : INFINITY;
  }
  if (!c.y.shows(s.y[i])) return INFINITY;
  return std::hypot(dx, c.y.pixel(s.y[i]) - mouse.y);
}

/// Series and value under the mouse.
std::optional<std::pair<std::size_t, std::size_t>> nearest(const Plot& plot, const PlotCanvas& c,
                                                           ImVec2 mouse) {
  std::optional<std::pair<std::size_t, std::size_t>> found;
  float least = 12; // pixels
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (std::size_t i = 0; i < count(plot.series[k]); ++i)
      if (const float d = distance(plot.series[k], i, c, mouse); d < least) {
        least = d;
        found.emplace(k, i);
      }
  return found;
}

void draw_tooltip(const Plot& plot, const PlotCanvas& c) {
  const auto found = nearest(plot, c, ImGui::GetIO().MousePos);
  if (!found) return;
  const auto [k, i] = *found;
  const PlotSeries& s = plot.series[k];
  const bool bars = s.kind == PlotKind::bars, has_y = s.kind != PlotKind::vertical;
  if (has_y && !bars) c.draw->AddCircle(c.at(s.x[i], s.y[i]), 6, text_colour, 0, 1.5F);
  std::string said = s.name;
  if (i < s.labels.size()) said += (said.empty() ? "" : "\n") + s.labels[i];
  const double x = bars ? border(s, i, c.x) : s.x[i];
  said += fmt::format("{}{}: {}", said.empty() ? "" : "\n", plot.x_label, short_text(x));
  if (bars) said += " to " + short_text(border(s, i + 1, c.x));
  if (has_y) said += fmt::format("\n{}: {}", plot.y_label, short_text(s.y[i]));
  ImGui::SetTooltip("%s", said.c_str());
}

} // namespace

PlotSeries bars_of(const Histogram& histogram, std::string name) {
  PlotSeries s{.name = std::move(name), .kind = PlotKind::bars};
  std::uint64_t all = histogram.nan + histogram.positive_infinite + histogram.negative_infinite +
                      histogram.below + histogram.above;
  for (const std::uint64_t n : histogram.counts) all += n;
  const HistogramRange& r = histogram.range;
  for (std::uint32_t i = 0; i < r.bins; ++i) {
    const double lo = r.edge(i), hi = r.edge(i + 1);
    const auto n = double(histogram.counts[i]);
    s.x.push_back(r.logarithmic ? std::sqrt(lo * hi) : (lo + hi) / 2);
    s.y.push_back(n);
    s.labels.push_back(short_text(all == 0 ? 0 : 100 * n / double(all)) + " %");
  }
  return s;
}

bool draw_plot(const char* id, const Plot& plot, ImVec2 size) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (size.x <= 0) size.x = room.x;
  if (size.y <= 0) size.y = room.y;
  size = {std::max(size.x, 40.0F), std::max(size.y, 40.0F)};
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(id, size);
  const bool hovered = ImGui::IsItemHovered();
  if (!ImGui::IsItemVisible()) return false;

  const PlotCanvas c = canvas_of(plot, origin, size);
  c.draw->AddRectFilled(origin, {origin.x + size.x, origin.y + size.y}, plot_ground);
  draw_axes(plot, c);
  c.draw->PushClipRect(c.lo, c.hi, true);
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (std::size_t i = 0; i < count(plot.series[k]); ++i) draw_value(plot.series[k], i, k, c);
  c.draw->PopClipRect();
  draw_legend(plot, c);
  if (hovered) draw_tooltip(plot, c);
  return hovered;
}

} // namespace lightcuts::viz
