// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// A map_Kd or map_Ke.
struct MtlMap {
  std::string file;
  bool clamp = false;            ///< -clamp on
  glm::vec2 scale{1}, offset{0}; ///< -s and -o: coordinates are scale * vt + offset
  bool operator==(const MtlMap&) const = default;
};

/// A material as its file has it.
struct MtlMaterial {
  std::string name;
  std::optional<glm::vec3> diffuse; ///< Kd
  glm::vec3 specular{0};            ///< Ks
  glm::vec3 emission{0};            ///< Ke
  bool has_emission = false;
  float exponent = 0;                 ///< Ns
  float opacity = 1;                  ///< d, or 1 - Tr
  std::optional<MtlMap> diffuse_map;  ///< map_Kd
  std::optional<MtlMap> emission_map; ///< map_Ke
};

/// The materials of an `.mtl`, and what of it does nothing.
struct MtlFile {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> notes; ///< without the file's name
};

/// Reads an `.mtl`. Statements that are not known are noted, not refused. Throws InputError, as
/// `file:line: message`, where one that is has other values than numbers, or too few.
[[nodiscard]] MtlFile read_mtl(const std::filesystem::path& file);

} // namespace lightcuts
