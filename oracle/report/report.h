// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace lightcuts::oracle {

/// One method at one threshold, compared with the exact picture. Errors are over the pixels that
/// see a surface; their formulas stand in image_error.h.
struct Run {
  std::string method;
  double threshold = 0;
  double build_seconds = 0;  ///< of the light tree; 0 where none is used
  double render_seconds = 0; ///< median of the interleaved runs
  double mean_cut_size = 0;
  double shadow_rays_per_pixel = 0;
  double rel_rmse = 0;
  double mrse = 0;
  double mean_relative_error = 0;
  double max_relative_error = 0;
  double mean_certified_error = 0; ///< relative, like the mean error
  std::uint64_t pixels_over_threshold = 0;
  std::uint64_t dark_pixels = 0;         ///< ended by the black level
  std::uint64_t size_limited_pixels = 0; ///< ended by the largest cut size
  double speedup_over_reference = 1;
  double efficiency = 0;       ///< 1 / (rel_rmse^2 render_seconds); 0 for the reference
  double optimal_cut_size = 0; ///< mean clairvoyant cut over a sample of pixels; 0: not measured
  double cut_efficiency = 0;   ///< optimal_cut_size / mean size of the same pixels' cuts
};

/// Everything that a report shows.
struct Report {
  std::string scene;
  std::uint64_t seed = 1;
  std::string builder; ///< of the light tree
  std::size_t lights = 0;
  std::size_t triangles = 0;
  glm::uvec2 size{0};
  std::uint64_t surface_pixels = 0;
  unsigned threads = 0;
  int repeats = 0; ///< interleaved runs per row
  float black_level = 0;
  std::vector<std::string> needs;    ///< what the scene needs, one line each
  std::vector<std::string> left_out; ///< what was left out, one line each
  std::vector<Run> runs;
  /// Pictures, in the order to show them: caption and the PNG file's name in the output folder.
  std::vector<std::pair<std::string, std::string>> pictures;
  /// Cut sizes of the pixels that see a surface, of the row that the pictures show.
  std::vector<float> cut_sizes;
};

} // namespace lightcuts::oracle
