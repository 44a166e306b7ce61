// SPDX-License-Identifier: MIT
#include <oracle/report/plots/plots.h>

#include <algorithm>

#include <fmt/format.h>
#include <oracle/report/plots/gnuplot.h>

#include <oracle/report/pages/report_numbers.h>
#include <oracle/report/plots/log_axis.h>

namespace lightcuts::oracle {
namespace {

/// A quantity of the runs of a method, in percent, against the threshold or time.
struct Series {
  std::string title;
  std::string points; // lines of "x y label"
  std::string style;
};

struct PlotDrawing {
  LogAxis x, y;
  std::vector<Series> series;

  void add(Series& to, double at_x, double at_y, const std::string& label) {
    if (LogAxis probe_x, probe_y; !probe_x.include(at_x) || !probe_y.include(at_y)) return;
    x.include(at_x);
    y.include(at_y);
    to.points += fmt::format("{:.17g} {:.17g} \"{}\"\n", at_x, at_y, label);
  }
};

std::vector<std::string> tree_methods(const Report& report) {
  std::vector<std::string> methods;
  for (const Run& run : report.runs)
    if (!is_reference(run) &&
        std::find(methods.begin(), methods.end(), run.method) == methods.end())
      methods.push_back(run.method);
  return methods;
}

std::vector<Run> by_threshold(const Report& report, const std::string& method) {
  std::vector<Run> runs;
  for (const Run& run : report.runs)
    if (run.method == method) runs.push_back(run);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Run& a, const Run& b) { return a.threshold < b.threshold; });
  return runs;
}

std::string data_blocks(const std::vector<Series>& series) {
  std::string text;
  for (std::size_t i = 0; i < series.size(); ++i)
    text += fmt::format("$data{} << EOD\n{}EOD\n", i, series[i].points);
  return text;
}

// What a plot command draws first: nothing, so that it is one without any series, too.
const char* const nothing = "plot NaN notitle";

std::string lines(const std::vector<Series>& series, bool labelled) {
  std::string text;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].points.empty()) continue;
    text += fmt::format(", $data{} using 1:2 with linespoints {} title {} noenhanced", i,
                        series[i].style, gnuplot_quoted(series[i].title));
    if (labelled)
      text += fmt::format(", $data{} using 1:2:3 with labels {} font ',12' "
                          "textcolor rgb '#444444' notitle",
                          i, i % 2 == 0 ? "left offset 0.7,0.5" : "right offset -0.7,-0.5");
  }
  return text;
}

std::string vertical_line(double x, const std::string& label, const char* side) {
  return fmt::format("set arrow from first {0:.17g}, graph 0 to first {0:.17g}, graph 1 nohead "
                     "lc rgb '#333333' lw 1.2 dt 2\n"
                     "set label {1} at first {0:.17g}, graph 0.97 {2} offset {3},0 noenhanced "
                     "textcolor rgb '#333333'\n",
                     x, gnuplot_quoted(label), side, side == std::string("left") ? 0.8 : -0.8);
}

Series error_of_method(PlotDrawing& drawing, const Report& report, const std::string& method) {
  Series series{method, "", fmt::format("lt {}", drawing.series.size() + 1)};
  for (const Run& run : by_threshold(report, method))
    drawing.add(series, run.render_seconds, 100 * run.mean_relative_error, threshold_text(run));
  return series;
}

struct Quantity {
  const char* name;
  double Run::*value;
};

// A colour per quantity; a dash and a point per method.
void add_quantities(PlotDrawing& drawing, const Report& report, const std::string& method,
                    int index, bool alone) {
  static constexpr Quantity quantities[] = {{"certified", &Run::mean_certified_error},
                                            {"largest", &Run::max_relative_error},
                                            {"mean", &Run::mean_relative_error}};
  static constexpr int colours[] = {3, 2, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    Series series{quantities[i].name, "", fmt::format("lt {} dt {}", colours[i], index % 5 + 1)};
    if (!alone) series.title += ", " + method;
    for (const Run& run : by_threshold(report, method))
      drawing.add(series, 100 * run.threshold, 100 * run.*(quantities[i].value), "");
    drawing.series.push_back(std::move(series));
  }
}

} // namespace

std::string error_against_time_plot(const Report& report) {
  PlotDrawing drawing;
  for (const std::string& method : tree_methods(report))
    drawing.series.push_back(error_of_method(drawing, report, method));
  std::string reference;
  for (const Run& run : report.runs)
    if (is_reference(run) && reference.empty() && drawing.x.include(run.render_seconds))
      reference = vertical_line(run.render_seconds, "reference (no error)", "right");
  return gnuplot_svg(data_blocks(drawing.series) + drawing.x.commands("x", " s") +
                     drawing.y.commands("y", " %%") + reference +
                     "set xlabel 'render time'\nset ylabel 'mean relative error'\n" + nothing +
                     lines(drawing.series, true));
}

std::string error_against_threshold_plot(const Report& report) {
  PlotDrawing drawing;
  const std::vector<std::string> methods = tree_methods(report);
  for (std::size_t i = 0; i < methods.size(); ++i)
    add_quantities(drawing, report, methods[i], static_cast<int>(i), methods.size() == 1);
  return gnuplot_svg(data_blocks(drawing.series) + drawing.x.commands("x", " %%") +
                     drawing.y.commands("y", " %%") +
                     "set xlabel 'threshold'\nset ylabel 'relative error'\nset key font ',13'\n" +
                     nothing + lines(drawing.series, false) +
                     ", x with lines lc rgb '#888888' lw 1 dt 2 title 'error = threshold'");
}

} // namespace lightcuts::oracle
