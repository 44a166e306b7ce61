// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// The radiance that comes from afar, as a latitude-longitude image; y is up.
///
/// As OpenEXR has it: the first row is the zenith (+y), the last the nadir; the middle of the image
/// looks along +z, its left and right edge along -z, a quarter from the left along +x, a quarter
/// from the right along -x. The centre of pixel (x, y) is at the polar angle pi (y + 1/2) / height
/// and the longitude pi - 2 pi (x + 1/2) / width, measured from +z towards +x.
struct EnvironmentMap {
  std::string name;                ///< of the file, for messages
  glm::uvec2 size{0};              ///< pixels
  std::vector<glm::vec3> radiance; ///< W/(m^2 sr), row by row from the top left, each finite, >= 0
  std::vector<std::string> notes;  ///< what the reader made up, one line each
};

/// Reads an image of any format that OpenImageIO knows, EXR and HDR above all; the values are taken
/// as linear (noted where they are stored as integers). Its first three channels count, R, G and B
/// where they have names; where it has fewer, the first for all. A component that is negative or
/// not a number becomes 0, one that is infinite the largest float, which is noted. Throws
/// InputError, naming the file, where it cannot be read, exceeds max_image_side, or is cropped.
[[nodiscard]] EnvironmentMap read_environment(const std::filesystem::path& file);

/// Throws InputError, naming file and pixel, where the map has no pixels, not size.x * size.y of
/// them, or one that is negative or not finite.
void validate(const EnvironmentMap& map);

} // namespace lightcuts
