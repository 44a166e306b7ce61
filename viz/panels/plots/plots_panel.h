// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <viz/model/workbench.h>
#include <viz/panels/picture/shown_picture.h>
#include <viz/panels/plots/plot.h>

namespace lightcuts::viz {

/// The histogram of cut sizes, and the oracle's report on the scene: error against time and against
/// threshold.
class PlotsPanel {
public:
  void draw(Workbench& workbench);

private:
  void draw_histogram(Workbench& workbench);
  void draw_report(Workbench& workbench);
  void draw_controls(Workbench& workbench);

  /// Which the report has beside the reference.
  std::vector<Method> methods_{methods::lightcuts, methods::paper};
  Plot histogram_;
  std::string beyond_histogram_; ///< in words
  std::uint64_t histogram_version_ = 0;
  std::shared_ptr<const Frame> histogram_of_;
};

} // namespace lightcuts::viz
