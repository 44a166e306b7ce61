// SPDX-License-Identifier: MIT
#include <viz/panels/plots/plots_panel.h>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/model/layers/histogram.h>
#include <viz/model/layers/kinds/cut_size.h>
#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

constexpr float thresholds[] = {0.005F, 0.01F, 0.02F, 0.04F, 0.08F, 0.16F};
constexpr std::uint32_t histogram_bins = 40;

/// Where a few cuts are far larger than the others, of those others.
Histogram cut_size_histogram(const LayerValues& layer, const LayerStatistics& statistics) {
  std::vector<float> values;
  for (std::size_t i = 0; i < layer.values.size(); ++i)
    if (layer.known[i] != 0 && layer.surface[i] != 0) values.push_back(layer.values[i]);
  if (statistics.known == 0) return histogram_of(values, {});
  const double most = std::max(automatic_scale(statistics, false).hi, statistics.least);
  return histogram_of(values, whole_number_range(statistics.least, most, histogram_bins));
}

Plot cut_size_plot(const Histogram& histogram, const LayerStatistics& statistics) {
  Plot plot;
  plot.x_label = "clusters";
  plot.y_label = "pixels";
  plot.series.push_back(bars_of(histogram, "cut size"));
  if (statistics.known > 0)
    plot.series.push_back({"mean", {statistics.mean}, {0}, {}, PlotKind::vertical});
  return plot;
}

/// A line per method of what x() and y() make of its runs.
template <class X, class Y>
std::vector<PlotSeries> lines(const oracle::Report& report, X&& x, Y&& y) {
  std::vector<PlotSeries> all;
  for (const oracle::Run& run : report.runs) {
    if (run.method == methods::reference.name) continue;
    if (all.empty() || all.back().name != run.method)
      all.push_back({run.method, {}, {}, {}, PlotKind::line});
    all.back().x.push_back(x(run));
    all.back().y.push_back(y(run));
    all.back().labels.push_back(fmt::format("{:g} %", 100 * run.threshold));
  }
  return all;
}

/// Mean error against x() of each run, both logarithmic.
template <class X>
Plot error_plot(const oracle::Report& report, const char* x_label, X&& x) {
  Plot plot;
  plot.x_label = x_label;
  plot.y_label = "mean relative error";
  plot.x_logarithmic = plot.y_logarithmic = true;
  plot.series = lines(report, x, [](const oracle::Run& r) { return r.mean_relative_error; });
  return plot;
}

Plot error_against_time(const oracle::Report& report) {
  Plot plot = error_plot(report, "seconds", [](const oracle::Run& r) { return r.render_seconds; });
  for (const oracle::Run& run : report.runs)
    if (run.method == methods::reference.name)
      plot.series.push_back({"reference", {run.render_seconds}, {0}, {}, PlotKind::vertical});
  return plot;
}

/// What has no place on a logarithmic axis: "exact, not shown: lightcuts 1 %, 2 %"; empty if none.
std::string exact_rows(const oracle::Report& report) {
  std::string names, last;
  for (const oracle::Run& run : report.runs) {
    if (run.method == methods::reference.name || run.mean_relative_error != 0) continue;
    names += run.method == last ? ", " : (names.empty() ? "" : "; ") + run.method + " ";
    names += fmt::format("{:g} %", 100 * run.threshold);
    last = run.method;
  }
  return names.empty() ? "" : "exact, not shown: " + names;
}

Plot error_against_threshold(const oracle::Report& report) {
  return error_plot(report, "threshold", [](const oracle::Run& r) { return r.threshold; });
}

} // namespace

void PlotsPanel::draw(Workbench& workbench) {
  const float height = std::max(
      110.0F, (ImGui::GetContentRegionAvail().y - 6 * ImGui::GetTextLineHeightWithSpacing()) / 3);
  draw_histogram(workbench);
  draw_plot("histogram", histogram_, {ImGui::GetContentRegionAvail().x, height});
  draw_controls(workbench);
  draw_report(workbench);
}

void PlotsPanel::draw_histogram(Workbench& workbench) {
  const LayerSources sources = workbench.sources(workbench.state.display, layers::cut_size);
  ImGui::TextUnformatted(fmt::format("Lights evaluated, {}{}",
                                     workbench.state.display.method()->name, beyond_histogram_)
                             .c_str());
  const bool complete = sources.frame->complete();
  // While the picture grows, every now and then.
  const std::uint64_t version = complete ? sources.frame->version() : sources.frame->version() / 64;
  if (histogram_of_ == sources.frame && histogram_version_ == version) return;
  histogram_of_ = sources.frame;
  histogram_version_ = version;
  const LayerValues layer = layer_values(layers::cut_size, sources);
  const LayerStatistics statistics = statistics_of(layer);
  const Histogram histogram = cut_size_histogram(layer, statistics);
  histogram_ = cut_size_plot(histogram, statistics);
  beyond_histogram_.clear();
  if (histogram.above > 0)
    beyond_histogram_ = fmt::format("; {} of {} pixels have more, at most {}", histogram.above,
                                    statistics.known, short_text(statistics.largest));
}

void PlotsPanel::draw_controls(Workbench& workbench) {
  ImGui::Separator();
  ImGui::TextUnformatted("Report of the oracle: error against run time");
  for (const Method method : all_methods) {
    if (method == methods::reference) continue;
    const auto chosen = std::find(methods_.begin(), methods_.end(), method);
    bool is_chosen = chosen != methods_.end();
    if (ImGui::Checkbox(method->name, &is_chosen)) {
      if (is_chosen)
        methods_.push_back(method);
      else
        methods_.erase(chosen);
    }
    tooltip(method->meaning);
    if (method != methods::stochastic_intensity && method != methods::lightcuts) ImGui::SameLine();
  }
  if (workbench.reporting()) {
    ImGui::ProgressBar(float(workbench.report_share()), {-6 * ImGui::GetFontSize(), 0});
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) workbench.cancel_report();
    return;
  }
  if (ImGui::Button("Run")) {
    oracle::MeasureConfig config;
    config.methods = {methods::reference};
    for (const Method method : all_methods)
      if (std::find(methods_.begin(), methods_.end(), method) != methods_.end())
        config.methods.push_back(method);
    config.thresholds.assign(std::begin(thresholds), std::end(thresholds));
    config.max_cut = workbench.state.shading.max_cut;
    config.repeats = 1;
    config.builder = workbench.scene()->request().builder;
    workbench.start_report(config);
  }
  tooltip("Renders the scene by its own camera with each method at thresholds from 0.5 % to 16 %, "
          "once, and compares with the reference. 'lightcuts-oracle report' does more.");
}

void PlotsPanel::draw_report(Workbench& workbench) {
  const auto& result = workbench.report();
  if (!result || result->scene != workbench.scene()) return;
  if (const std::string exact = exact_rows(result->report); !exact.empty())
    ImGui::TextColored(quiet_text, "%s", exact.c_str());
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const ImVec2 size{left.x, std::max(110.0F, left.y / 2 - 6)};
  draw_plot("time", error_against_time(result->report), size);
  draw_plot("threshold", error_against_threshold(result->report), size);
}

} // namespace lightcuts::viz
