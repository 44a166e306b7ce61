// SPDX-License-Identifier: MIT
#include <oracle/cases/counterexample_json.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include <oracle/records/record_json.h>

namespace lightcuts::oracle {
namespace {

std::string scalar_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_one_line(const Json& json) {
  if (!json.is_structured() || json.empty()) return true;
  if (json.is_object()) return false;
  return std::none_of(json.begin(), json.end(), [](const Json& j) { return j.is_structured(); });
}

/// Indented, but for lists of plain values.
void append(std::string& text, const Json& json, std::size_t indent) {
  if (!json.is_structured() || json.empty()) {
    text += scalar_text(json);
    return;
  }
  const std::string space = is_one_line(json) ? " " : "\n" + std::string(indent + 2, ' ');
  std::string before = is_one_line(json) ? "" : space;
  text += json.is_object() ? "{" : "[";
  for (const auto& [key, value] : json.items()) {
    text += before;
    if (json.is_object()) text += scalar_text(key) + ": ";
    append(text, value, indent + 2);
    before = "," + space;
  }
  if (!is_one_line(json)) text += "\n" + std::string(indent, ' ');
  text += json.is_object() ? "}" : "]";
}

} // namespace

std::string counterexample_json(const SavedCounterexample& saved) {
  Json json{{"schema", counterexample_schema}};
  append_fields(json, saved);
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

} // namespace lightcuts::oracle
