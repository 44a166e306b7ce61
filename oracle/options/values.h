// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <lightcuts/render/io/scene_request.h>

/// Readers of what is typed as the value of an option. Each has a check for CLI11: what is wrong
/// with the text, or nothing.
namespace lightcuts::options {

/// "A<separator>B" as two whole numbers of at most five digits each.
[[nodiscard]] std::optional<glm::uvec2> parse_pair(const std::string& text, char separator);

/// "WIDTHxHEIGHT" of an image or window: each from 1 to max_image_side.
[[nodiscard]] std::optional<glm::uvec2> parse_size(const std::string& text);
[[nodiscard]] std::string check_size(const std::string& text);

/// "X,Y,Z,TX,TY,TZ" or that and ",FOV": where a camera is, what it looks at, and its vertical field
/// of view, degrees, above 0 and below 180. All finite, the two points not the same.
[[nodiscard]] std::optional<CameraRequest> parse_camera(const std::string& text);
[[nodiscard]] std::string check_camera(const std::string& text);
/// What parse_camera() reads as that.
[[nodiscard]] std::string camera_text(const Camera& camera);

/// "2%" or "0.02" as 0.02; nothing for any other text, such as "auto", or below 0.
[[nodiscard]] std::optional<float> parse_threshold(const std::string& text);
/// "auto" will do, too.
[[nodiscard]] std::string check_threshold(const std::string& text);
/// A number that parse_count() reads.
[[nodiscard]] std::string check_count(const std::string& text);
/// A whole number above 0. CLI11 takes -1 for the largest.
[[nodiscard]] std::string check_positive(const std::string& text);
[[nodiscard]] std::string check_not_negative(const std::string& text);
/// At least 64MiB that parse_memory() reads: less is not enough to load a library.
[[nodiscard]] std::string check_memory(const std::string& text);
/// A finite number above 0.
[[nodiscard]] std::string check_distance(const std::string& text);

} // namespace lightcuts::options
