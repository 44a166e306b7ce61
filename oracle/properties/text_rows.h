// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include <fmt/format.h>

#include <oracle/cases/case_text.h>

namespace lightcuts::oracle {

/// A name, a value and a remark, one below the other's.
inline std::string line(const std::string& name, const std::string& value,
                        const std::string& note = "") {
  std::string text = fmt::format("  {:<20} {:<24} {}", name, value, note);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

/// A name, and a text per channel.
inline std::string row(const std::string& name, const std::array<std::string, 3>& channels) {
  return line(name, channels[0], fmt::format("{:<24} {}", channels[1], channels[2]));
}

template <class ChannelText>
std::string row_of(const std::string& name, ChannelText&& text) {
  return row(name, {text(0), text(1), text(2)});
}

/// Of doubles or floats.
template <class Vector>
std::string number_row(const std::string& name, const Vector& v) {
  return row_of(name, [&](int c) { return fmt::format("{:.17g}", double(v[c])); });
}

inline std::string channel_head() { return row("", {"r", "g", "b"}); }

} // namespace lightcuts::oracle
