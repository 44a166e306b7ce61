// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>
#include <oracle/records/bits.h>
#include <oracle/records/kinds_of_value.h>

/// Records as text for people: decimals, with digits enough to tell floats apart.
namespace lightcuts::oracle {

/// "0.1"
[[nodiscard]] std::string text_of(float value);
/// "(0, 0.5, 1)"
[[nodiscard]] std::string text_of(const glm::vec3& value);
/// "3 x 2"
[[nodiscard]] std::string text_of(const glm::uvec2& value);
/// "0 3 4 ... of 17": the first twelve.
[[nodiscard]] std::string text_of(const std::vector<std::uint32_t>& value);

template <Record R, class Line>
void for_each_line(const R& record, Line&& line);

/// Of a record "name value, name value", without what is optional and has its default value; a kind
/// goes without its name.
template <class Value>
requires(Record<Value> || SharedRecord<Value> || is_variant<Value> || is_vector<Value> ||
         NamedEnum<Value> || std::is_integral_v<Value> || std::is_same_v<Value, std::string>)
    [[nodiscard]] std::string text_of(const Value& value) {
  std::string text;
  if constexpr (Record<Value>) {
    for_each_line(value, [&text](const std::string& name, const std::string& part) {
      text += (text.empty() ? "" : ", ") + (name == "kind" ? part : name + " " + part);
    });
  } else if constexpr (SharedRecord<Value>) {
    text = text_of(value.table());
  } else if constexpr (is_variant<Value>) {
    text = std::visit(
        [](const auto& alternative) {
          const std::string fields = text_of(alternative);
          return alternative.name + (fields.empty() ? "" : ", " + fields);
        },
        value);
  } else if constexpr (is_vector<Value>) {
    for (const auto& element : value) text += (text.empty() ? "" : "; ") + text_of(element);
  } else if constexpr (NamedEnum<Value>) {
    text = lightcuts::name_of(value);
  } else {
    text = fmt::format("{}", value);
  }
  return text;
}

/// Calls line(name, text) for each field with what text_of() says; for those of a record in it,
/// too.
template <Record R, class Line>
void for_each_line(const R& record, Line&& line) {
  const auto show = [&line]<class Value>(std::string name, const Value& value, const Value& usual,
                                         const Domain& domain) {
    if (domain.optional && same_bits(value, usual)) return;
    std::replace(name.begin(), name.end(), '_', ' ');
    if constexpr (Record<Value>)
      for_each_line(value, line);
    else
      line(name, text_of(value));
  };
  for_each_field(record, R{}, show);
}

} // namespace lightcuts::oracle
