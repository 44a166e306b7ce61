// SPDX-License-Identifier: MIT
#include <oracle/records/record_json.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include <oracle/cases/hex_float.h>

namespace lightcuts::oracle {
namespace {

constexpr double largest = std::numeric_limits<float>::max();

template <class Integer>
Integer whole_number(const JsonElement& element, const Domain& domain) {
  constexpr Integer most = std::numeric_limits<Integer>::max();
  return Integer(
      element.whole_number(domain.least > 0 ? std::uint64_t(domain.least) : 0,
                           domain.most < double(most) ? std::uint64_t(domain.most) : most));
}

} // namespace

Json exact_json(float value) { return hex_text(value); }

Json exact_json(const glm::vec3& value) {
  return Json::array({hex_text(value.x), hex_text(value.y), hex_text(value.z)});
}

Json decimal_json(float value) {
  if (value == std::trunc(value) && std::abs(value) < 0x1p53F) return std::int64_t(value);
  const std::string text = fmt::format("{}", value);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

Json decimal_json(const glm::vec3& value) {
  return Json::array({decimal_json(value.x), decimal_json(value.y), decimal_json(value.z)});
}

void read_value(const JsonElement& element, float& value, const Domain& domain) {
  if (element.is_number()) {
    value = element.number();
  } else {
    const std::string text = element.string();
    const std::optional<float> read = hex_float(text);
    if (!read)
      element.refuse(InputFault::malformed_file,
                     fmt::format("is \"{}\", expected a finite float such as \"0x1.8p+1\"", text));
    value = *read;
  }
  if (double(value) < domain.least || double(value) > domain.most)
    element.refuse(domain.least == 0 ? fault_of(value) : InputFault::out_of_domain,
                   domain.least == 0 && domain.most > largest
                       ? "is negative"
                       : fmt::format("is {}, expected {} to {}", value, domain.least, domain.most));
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
  if (!element.is_list() || element.size() != 2)
    element.refuse(InputFault::malformed_file, "is not a width and a height");
  for (int i = 0; i < 2; ++i) read_value(element.at(std::size_t(i)), value[i], domain);
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
