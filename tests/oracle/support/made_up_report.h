// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/report/report.h>

namespace lightcuts::oracle {

inline Run made_up_run(const char* method, double threshold) {
  Run run;
  run.method = method;
  run.threshold = threshold;
  run.build_seconds = 0.083;
  run.render_seconds = 1 + 0.02 / threshold;
  run.mean_cut_size = 155.25;
  run.shadow_rays_per_pixel = 140;
  run.rel_rmse = 0.4 * threshold;
  run.mrse = threshold * threshold;
  run.mean_relative_error = 0.37 * threshold;
  run.max_relative_error = 2.5 * threshold;
  run.mean_certified_error = 4 * threshold;
  run.pixels_over_threshold = 41;
  run.dark_pixels = 3;
  run.size_limited_pixels = 2;
  run.speedup_over_reference = 41.3 / run.render_seconds;
  run.efficiency = 1000;
  run.optimal_cut_size = 30;
  run.cut_efficiency = 0.19;
  return run;
}

/// A small report: the reference and lightcuts at two thresholds.
inline Report made_up_report() {
  Report report;
  report.scene = "room";
  report.builder = "greedy";
  report.lights = 20000;
  report.triangles = 1234567;
  report.size = {640, 360};
  report.surface_pixels = 200000;
  report.threads = 2;
  report.repeats = 5;
  report.black_level = 0.001F;
  report.needs = {"omni lights"};
  report.left_out = {"directional tree: no directional lights"};
  Run reference;
  reference.method = "reference";
  reference.render_seconds = 41.3;
  reference.mean_cut_size = 20000;
  report.runs = {reference, made_up_run("lightcuts", 0.02), made_up_run("lightcuts", 0.1)};
  report.cut_sizes = {1, 2, 2, 3, 1000};
  return report;
}

} // namespace lightcuts::oracle
