// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include <viz/model/state/app_settings.h>

namespace lightcuts::viz {

class App;

/// Shows the window until it is closed. `start` is called once, before the first frame, `end` once
/// the window is closed, with the settings as they are then; where a scene is being opened at that
/// moment the process ends there, with code 0. scale: nothing for the screen's own. Throws GlError
/// where there is no display or no OpenGL 3.3. Where the display goes away meanwhile, the process
/// ends with code 3, after `end`.
void run_window(const AppSettings& settings, std::optional<float> scale,
                const std::filesystem::path& output, const std::function<void(App&)>& start,
                const std::function<void(const AppSettings&)>& end);

} // namespace lightcuts::viz
