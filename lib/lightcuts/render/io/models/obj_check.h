// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lightcuts {

/// Refuses what Assimp takes without a word: cut-off lines, words for numbers, numbers out of
/// float's range, indices out of range, in an `.obj` and in the `.mtl` files it names. Throws
/// InputError as `file:line: message`. Returns the material libraries that are not there.
std::vector<std::string> check_obj(const std::filesystem::path& file);

} // namespace lightcuts
