// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include <viz/model/layers/histogram.h>

namespace lightcuts::viz {

enum class PlotKind {
  line, ///< with dots where there are labels
  points,
  bars,    ///< one at each x, ascending, as wide as halfway to its neighbours
  vertical ///< lines from bottom to top at each x, whatever y
};

struct PlotSeries {
  std::string name;                ///< in the legend; empty: not there
  std::vector<double> x, y;        ///< what is NaN, infinite, or not positive on a logarithmic axis
                                   ///< is left out
  std::vector<std::string> labels; ///< of the values, in tooltips; may be fewer
  PlotKind kind = PlotKind::line;
};

struct Plot {
  std::string x_label, y_label; ///< with their units
  bool x_logarithmic = false;   ///< default false
  bool y_logarithmic = false;   ///< default false
  std::vector<PlotSeries> series;
};

/// The bins of a histogram, with the percentage of its values in each as a label.
[[nodiscard]] PlotSeries bars_of(const Histogram& histogram, std::string name);

/// Draws a plot with axes that hold all of its values, and beside the mouse what is nearest to it.
/// size in pixels; 0: all there is room for. Whether the mouse is over it.
bool draw_plot(const char* id, const Plot& plot, ImVec2 size);

} // namespace lightcuts::viz
