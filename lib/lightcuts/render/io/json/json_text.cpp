// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/json/json_text.h>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {

std::string plain_message(const nlohmann::json::exception& error) {
  std::string message = error.what();
  const std::size_t bracket = message.find("] ");
  if (bracket != std::string::npos) message.erase(0, bracket + 2);
  const std::string prefix = "parse error at ";
  if (message.compare(0, prefix.size(), prefix) == 0) message.erase(0, prefix.size());
  return one_line(message);
}

nlohmann::json parse_json(const std::string& file, const std::string& text) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(InputFault::malformed_file, fmt::format("{}: {}", file, plain_message(error)));
  }
}

} // namespace lightcuts
