// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/cases/case.h>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {

/// "(0, 0.5, 1)", with digits enough to tell floats apart.
[[nodiscard]] std::string text_of(const glm::vec3& v);
/// The first digits, as many as tell doubles apart or as asked for; 14 beside a long exponent.
[[nodiscard]] std::string text_of(const Exact& value, int digits = 17);

/// The text and a line's end, broken into lines of at most 100 columns, if no word is longer; all
/// but the first are indented.
[[nodiscard]] std::string wrapped(const std::string& text);

/// One line each, or as many as there are fields; without hexadecimal digits.
[[nodiscard]] std::string text_of(const Light& light);
[[nodiscard]] std::string text_of(const gen::View& view);
[[nodiscard]] std::string text_of(const CutConfig& cut);
[[nodiscard]] std::string text_of(const Case& on);

} // namespace lightcuts::oracle
