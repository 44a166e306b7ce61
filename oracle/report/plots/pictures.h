// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/render/images/film.h>
#include <lightcuts/render/view/renderer.h>
#include <oracle/report/light_groups.h>

namespace lightcuts::oracle {

/// What there is to show of a rendering.
struct PictureSource {
  const Rendering& rendering;
  const Rendering* reference = nullptr; ///< null: no errors are shown
  float black_level = 0;
  std::string scene;
  std::uint64_t seed = 1;
  float threshold = 0;
  std::span<const GroupPicture> groups = {}; ///< of the same scene
};

/// Everything as float channels: R G B, reference.R …, cut.size, cut.bound (certified error, summed
/// over channels), cut.error (true error, likewise), cut.slack (their ratio; 0 where the error is),
/// rays.shadow, time.us; of each group of lights group.NAME.R …, what it adds to the picture, and
/// group.NAME.bound, its certified error; metadata scene, seed, threshold, version.
[[nodiscard]] Film film_of(const PictureSource& source);

/// Stages image.exr, the picture and its heat maps as PNG. Returns captions and file names, in the
/// order to show them.
std::vector<std::pair<std::string, std::string>> write_pictures(const PictureSource& source,
                                                                OutputFolder& folder);

} // namespace lightcuts::oracle
