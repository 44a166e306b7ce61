// SPDX-License-Identifier: MIT
#include <oracle/records/record_json.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include <oracle/numbers/hex_float.h>
#include <oracle/numbers/same_digits.h>

namespace lightcuts::oracle {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

template <class Integer>
Integer whole_number(const JsonElement& element, const Domain& domain) {
  constexpr Integer most = std::numeric_limits<Integer>::max();
  return Integer(
      element.whole_number(domain.least > 0 ? std::uint64_t(domain.least) : 0,
                           domain.most < double(most) ? std::uint64_t(domain.most) : most));
}

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

/// Refuses a number outside the domain.
template <class Number>
void require_within(const JsonElement& element, Number value, const Domain& domain) {
  if (double(value) >= domain.least && double(value) <= domain.most) return;
  element.refuse(domain.least == 0 ? fault_of(value) : InputFault::out_of_domain,
                 domain.least == 0 && domain.most > largest_float
                     ? "is negative"
                     : fmt::format("is {}, expected {} to {}", value, domain.least, domain.most));
}

template <class Vector>
void read_pair(const JsonElement& element, Vector& value, const Domain& domain) {
  if (!element.is_list() || element.size() != 2)
    element.refuse(InputFault::malformed_file, "is not a list of two numbers");
  for (int i = 0; i < 2; ++i) read_value(element.at(std::size_t(i)), value[i], domain);
}

} // namespace

std::string indented(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text;
}

Json exact_json(float value) { return hex_text(value); }

Json exact_json(const glm::vec3& value) {
  return Json::array({hex_text(value.x), hex_text(value.y), hex_text(value.z)});
}

Json decimal_json(float value) {
  if (value == std::trunc(value) && std::abs(value) < 0x1p53F) return std::int64_t(value);
  return same_digits(value);
}

Json decimal_json(const glm::vec3& value) {
  return Json::array({decimal_json(value.x), decimal_json(value.y), decimal_json(value.z)});
}

void read_value(const JsonElement& element, float& value, const Domain& domain) {
  if (!element.is_string()) {
    value = element.number();
  } else {
    const std::string text = element.string();
    const std::optional<float> read = hex_float(text);
    if (!read)
      element.refuse(InputFault::malformed_file,
                     fmt::format("is \"{}\", expected a finite float such as \"0x1.8p+1\"", text));
    value = *read;
  }
  require_within(element, value, domain);
}

void read_value(const JsonElement& element, double& value, const Domain& domain) {
  value = element.wide_number();
  require_within(element, value, domain);
}

void read_value(const JsonElement& element, glm::vec3& value, const Domain& domain) {
  if (!element.is_list()) element.refuse(InputFault::malformed_file, "is not a list");
  if (element.size() != 3)
    element.refuse(InputFault::malformed_file,
                   fmt::format("has {} elements, expected three", element.size()));
  for (int i = 0; i < 3; ++i) read_value(element.at(std::size_t(i)), value[i], domain);
  // As LightSet demands it.
  const double length = glm::length(glm::dvec3(value));
  if (domain.unit && !(std::abs(length - 1) <= 1e-5))
    element.refuse(InputFault::not_unit, fmt::format("has length {}, not 1", length));
}

void read_value(const JsonElement& element, glm::uvec2& value, const Domain& domain) {
  read_pair(element, value, domain);
}

void read_value(const JsonElement& element, glm::dvec2& value, const Domain& domain) {
  read_pair(element, value, domain);
}

void read_value(const JsonElement& element, std::uint32_t& value, const Domain& domain) {
  value = whole_number<std::uint32_t>(element, domain);
}

void read_value(const JsonElement& element, std::uint64_t& value, const Domain& domain) {
  value = whole_number<std::uint64_t>(element, domain);
}

void read_value(const JsonElement& element, bool& value, const Domain& /*domain*/) {
  value = element.boolean();
}

void read_value(const JsonElement& element, std::string& value, const Domain& /*domain*/) {
  value = element.string();
}

} // namespace lightcuts::oracle
