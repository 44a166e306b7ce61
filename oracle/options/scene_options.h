// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <lightcuts/render/io/scene_request.h>

namespace CLI {
class App;
} // namespace CLI

namespace lightcuts::options {

/// Adds SCENE, `size_option` ("--size") of the image, --camera, --allow-outside, and what makes
/// lights: --lights,
/// --area-lights, --environment, --environment-lights, --vpls, --surfels and --min-distance. What
/// is not given stays as the request has it; it must outlive the command.
void add_scene_options(CLI::App& command, SceneRequest& request, const std::string& size_option);

/// --builder: of the light tree.
void add_builder_option(CLI::App& command, Builder& builder);

/// --threshold: what parse_threshold() reads; nothing for "auto".
void add_threshold_option(CLI::App& command, std::optional<float>& threshold);

/// --max-cut.
void add_max_cut_option(CLI::App& command, std::uint32_t& max_cut);

} // namespace lightcuts::options
