// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <lightcuts/render/images/film.h>

#include <viz/model/layers/colouring.h>
#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// The layers of the display as far as anything of them is known: R G B and, by their names, the
/// others. What is not known is NaN. Metadata: scene, method, threshold, version. Of the raster
/// preview, which has an image and nothing else, `shown` is that image.
[[nodiscard]] Film film_of(Workbench& workbench, const LayerValues& shown);

/// Writes NAME.png (what is given: the layer that is shown, in its colours), NAME.exr (film_of())
/// and NAME.json (view_state_json()) to the folder, which is made; all or nothing. Throws
/// InputError. Needs an open scene.
void save_view(Workbench& workbench, const Coloured& shown, const LayerValues& values,
               const std::filesystem::path& folder, const std::string& name);

} // namespace lightcuts::viz
