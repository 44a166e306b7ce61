// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/report/report.h>

namespace lightcuts::oracle {

/// Calls f(name, value) for each column of a run, in the order of report.json and report.csv.
template <class F>
void for_each_column(const Run& run, F&& f) {
  f("method", run.method);
  f("threshold", run.threshold);
  f("build_seconds", run.build_seconds);
  f("render_seconds", run.render_seconds);
  f("mean_cut_size", run.mean_cut_size);
  f("shadow_rays_per_pixel", run.shadow_rays_per_pixel);
  f("rel_rmse", run.rel_rmse);
  f("mrse", run.mrse);
  f("mean_relative_error", run.mean_relative_error);
  f("max_relative_error", run.max_relative_error);
  f("mean_certified_error", run.mean_certified_error);
  f("pixels_over_threshold", run.pixels_over_threshold);
  f("dark_pixels", run.dark_pixels);
  f("size_limited_pixels", run.size_limited_pixels);
  f("speedup_over_reference", run.speedup_over_reference);
  f("efficiency", run.efficiency);
  f("optimal_cut_size", run.optimal_cut_size);
  f("cut_efficiency", run.cut_efficiency);
}

} // namespace lightcuts::oracle
