// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "model/app_settings.h"

namespace lightcuts::viz {

class App;

/// Shows the window until it is closed; `start` is called once, before the first frame. The
/// settings are returned as they are then. scale: nothing for the screen's own. Throws GlError
/// where there is no display or no OpenGL 3.3.
AppSettings run_window(const AppSettings& settings, std::optional<float> scale,
                       const std::filesystem::path& output, const std::function<void(App&)>& start);

} // namespace lightcuts::viz
