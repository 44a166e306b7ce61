// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A scene that is made in code. Metres, y up.
struct BuiltinScene {
  std::string name;
  std::string description; ///< one line, for a list of scenes; names the parameters and defaults
};

/// All built-in scenes, in the order in which to list them.
[[nodiscard]] const std::vector<BuiltinScene>& builtin_scenes();

/// Whether `spec`, up to its first '?', is the name of a built-in scene.
[[nodiscard]] bool is_builtin(std::string_view spec);

/// Makes the scene `name` or `name?parameter=value&parameter=value`; the same spec gives the same
/// bits. Throws InputError, naming scene and parameter, for an unknown name or parameter, a value
/// that is not what the parameter expects, and a parameter given twice.
[[nodiscard]] Scene make_builtin(const std::string& spec);

} // namespace lightcuts
