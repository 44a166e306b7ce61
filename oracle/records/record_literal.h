// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>
#include <oracle/numbers/hex_float.h>
#include <oracle/records/bits.h>
#include <oracle/records/kinds_of_value.h>

namespace lightcuts::oracle {

[[nodiscard]] inline std::string braced(const std::vector<std::string>& parts) {
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

/// A C++ initialiser of the value, exact: in namespace lightcuts, on one line. Fields of records
/// are designated; those with their default values are left out.
template <class Value>
[[nodiscard]] std::string literal_of(const Value& value) {
  std::vector<std::string> parts;
  if constexpr (Record<Value>) {
    for_each_field(value, Value{},
                   [&](const char* name, const auto& part, const auto& usual, Domain) {
                     if (!same_bits(part, usual))
                       parts.push_back(fmt::format(".{} = {}", name, literal_of(part)));
                   });
  } else if constexpr (SharedRecord<Value>) {
    return type_name<Value>() + "(" + literal_of(value.table()) + ")";
  } else if constexpr (is_variant<Value>) {
    return std::visit(
        []<class T>(const T& alternative) { return type_name<T>() + literal_of(alternative); },
        value);
  } else if constexpr (is_vector<Value>) {
    for (const auto& element : value) parts.push_back(literal_of(element));
  } else if constexpr (std::is_same_v<Value, glm::vec3> || std::is_same_v<Value, glm::uvec2>) {
    for (int i = 0; i < Value::length(); ++i) parts.push_back(literal_of(value[i]));
  } else if constexpr (std::is_same_v<Value, float>) {
    return hex_text(value) + "F";
  } else if constexpr (std::is_same_v<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (NamedEnum<Value>) {
    std::string name = lightcuts::name_of(value);
    std::replace(name.begin(), name.end(), '-', '_');
    return type_name<Value>() + "::" + name;
  } else {
    return fmt::format("{}U", value);
  }
  return braced(parts);
}

} // namespace lightcuts::oracle
