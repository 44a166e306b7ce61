// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <lightcuts/render/film.h>

#include "colouring.h"
#include "workbench.h"

namespace lightcuts::viz {

/// The layers of the display as far as anything of them is known: R G B and, by their names, the
/// others. What is not known is NaN, however it is shown. Metadata: scene, method, threshold,
/// version.
[[nodiscard]] Film film_of(Workbench& workbench);

/// Writes NAME.png (what is given: the layer that is shown, in its colours), NAME.exr (film_of())
/// and NAME.json (view_state_json()) to the folder, which is made; all or nothing. Throws
/// InputError. Needs an open scene.
void save_view(Workbench& workbench, const Coloured& shown, const std::filesystem::path& folder,
               const std::string& name);

} // namespace lightcuts::viz
