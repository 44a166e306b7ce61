// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace lightcuts {

/// Parses JSON. Throws InputError as `file: line L, column C: message`.
nlohmann::json parse_json(const std::string& file, const std::string& text);

/// The library's message in one line, without its "[json.exception....]".
std::string plain_message(const nlohmann::json::exception& error);

} // namespace lightcuts
