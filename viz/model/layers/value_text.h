// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <glm/vec3.hpp>

/// Numbers for narrow places: legends, and the inside of pixels.
namespace lightcuts::viz {

/// 4 significant digits, without trailing zeros: "0.1235", "12.5", "1.2e-5"; whole numbers below a
/// million in full: "123457". "inf", "-inf", "nan".
[[nodiscard]] std::string short_text(double value);

/// "0.1 0.2 0.3"; one number where the channels are alike.
[[nodiscard]] std::string rgb_text(const glm::dvec3& value);

/// A time in seconds: "0.42 ms", "35 ms", "0.3 s", "12 s", "1 min 20 s", "2 h 5 min".
[[nodiscard]] std::string duration_text(double seconds);

} // namespace lightcuts::viz
