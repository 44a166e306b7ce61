// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/cases/case.h>
#include <oracle/records/record_text.h>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {

/// The first digits, as many as tell doubles apart or as asked for; 14 beside a long exponent.
[[nodiscard]] std::string text_of(const Exact& value, int digits = 17);

/// The text and a line's end, broken into lines of at most 100 columns, if no word is longer; all
/// but the first are indented by so many.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t indent = 2);

/// A line for each field, indented.
[[nodiscard]] std::string lines_of(const gen::View& view);
/// A line for each light, view, triangle and other field.
[[nodiscard]] std::string text_of(const Case& on);

} // namespace lightcuts::oracle
