// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/render/io/json/json_element.h>
#include <nlohmann/json.hpp>
#include <oracle/records/bits.h>
#include <oracle/records/kinds_of_value.h>

/// Records as JSON. A variant has the name of its alternative as "kind".
namespace lightcuts::oracle {

using Json = nlohmann::ordered_json;

/// Text of it, indented, but with lists of plain values on one line. Bytes that are no UTF-8 are
/// replaced.
[[nodiscard]] std::string indented(const Json& json);

/// How floats are written; either way every bit comes back.
enum class Floats {
  /// Hexadecimal strings, "0x1.8p+1" for 3; beside them, as KEY_decimal, are decimals for readers.
  hexadecimal,
  decimal ///< numbers
};

[[nodiscard]] Json exact_json(float value);
[[nodiscard]] Json exact_json(const glm::vec3& value);
/// The number in as few digits as tell it from other floats; whole numbers without a fraction.
[[nodiscard]] Json decimal_json(float value);
[[nodiscard]] Json decimal_json(const glm::vec3& value);

/// Whether a field has a decimal beside it.
template <class Value>
inline constexpr bool is_of_floats =
    std::is_same_v<Value, float> || std::is_same_v<Value, glm::vec3>;

template <Record R>
void append_fields(Json& json, const R& record, Floats floats = Floats::hexadecimal);

template <class Value>
[[nodiscard]] Json json_of(const Value& value, Floats floats = Floats::hexadecimal) {
  Json json;
  if constexpr (Record<Value>) {
    json = Json::object();
    append_fields(json, value, floats);
  } else if constexpr (SharedRecord<Value>) {
    json = json_of(value.table(), floats);
  } else if constexpr (is_variant<Value>) {
    std::visit(
        [&](const auto& alternative) {
          json["kind"] = alternative.name;
          append_fields(json, alternative, floats);
        },
        value);
  } else if constexpr (is_vector<Value>) {
    json = Json::array();
    for (const auto& element : value) json.push_back(json_of(element, floats));
  } else if constexpr (is_optional<Value>) {
    if (value) json = json_of(*value, floats);
  } else if constexpr (is_of_floats<Value>) {
    json = floats == Floats::decimal ? decimal_json(value) : exact_json(value);
  } else if constexpr (is_glm_vector<Value>) {
    json = {value.x, value.y};
  } else if constexpr (NamedChoice<Value>) {
    json = name_of(value);
  } else if constexpr (NamedEnum<Value>) {
    json = lightcuts::name_of(value);
  } else {
    json = value;
  }
  return json;
}

template <Record R>
void append_fields(Json& json, const R& record, Floats floats) {
  const auto append = [&]<class Value>(const std::string& name, const Value& value,
                                       const Value& usual, const Domain& domain) {
    if (domain.optional && same_bits(value, usual)) return;
    if constexpr (Record<Value>)
      if (domain.inlined) return append_fields(json, value, floats);
    json[name] = json_of(value, floats);
    if constexpr (is_of_floats<Value>)
      if (floats == Floats::hexadecimal) json[name + "_decimal"] = decimal_json(value);
  };
  for_each_field(record, R{}, append);
}

/// Readers of what json_of() writes; decimals beside are ignored, and a number will do for a
/// hexadecimal string. Where anything is missing, unknown or out of its domain they throw JsonError
/// that names it.
void read_value(const JsonElement& element, float& value, const Domain& domain);
void read_value(const JsonElement& element, double& value, const Domain& domain);
void read_value(const JsonElement& element, glm::vec3& value, const Domain& domain);
void read_value(const JsonElement& element, glm::uvec2& value, const Domain& domain);
void read_value(const JsonElement& element, glm::dvec2& value, const Domain& domain);
void read_value(const JsonElement& element, std::uint32_t& value, const Domain& domain);
void read_value(const JsonElement& element, std::uint64_t& value, const Domain& domain);
void read_value(const JsonElement& element, bool& value, const Domain& domain);
void read_value(const JsonElement& element, std::string& value, const Domain& domain);

/// The index of the element's text among the names.
template <class Names>
[[nodiscard]] std::size_t index_among(const JsonElement& element, const Names& names) {
  const std::string text = element.string();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text == names[i]) return i;
  element.refuse(InputFault::unknown_name,
                 fmt::format("is \"{}\", expected one of: {}", text, fmt::join(names, ", ")));
}

template <NamedEnum Enum>
void read_value(const JsonElement& element, Enum& value, const Domain& /*domain*/) {
  value = Enum(index_among(element, names_of(value)));
}

template <NamedChoice Choice>
void read_value(const JsonElement& element, Choice& value, const Domain& /*domain*/) {
  const auto values = values_of(std::type_identity<Choice>{});
  std::vector<std::string> names;
  names.reserve(std::size(values));
  for (const Choice& each : values) names.emplace_back(name_of(each));
  value = values[index_among(element, names)];
}

/// The keys of a record's fields, and of decimals beside them.
template <Record R>
void append_keys(std::vector<std::string>& keys) {
  for_each_field<R>([&keys]<class Value, class D>(const Field<R, Value, D>& field) {
    if constexpr (Record<Value>)
      if (field.domain_in(R{}).inlined) return append_keys<Value>(keys);
    keys.emplace_back(field.name);
    if constexpr (is_of_floats<Value>) keys.push_back(keys.back() + "_decimal");
  });
}

template <Record R>
void read_fields(const JsonElement& element, R& record);
template <SharedRecord Value>
void read_value(const JsonElement& element, Value& value, const Domain& domain);
template <class T>
void read_value(const JsonElement& element, std::vector<T>& list, const Domain& domain);
template <class T>
void read_value(const JsonElement& element, std::optional<T>& value, const Domain& domain);
template <class... Ts>
void read_value(const JsonElement& element, std::variant<Ts...>& value, const Domain& domain);

/// An object with a record's fields and those of `further`.
template <Record R>
void read_record(const JsonElement& element, R& record, std::vector<std::string> further = {}) {
  append_keys<R>(further);
  element.expect_keys(further);
  read_fields(element, record);
}

template <Record R>
void read_value(const JsonElement& element, R& record, const Domain& /*domain*/) {
  read_record(element, record);
}

template <Record R>
void read_fields(const JsonElement& element, R& record) {
  for_each_field(record, [&]<class Value>(const char* name, Value& value, const Domain& domain) {
    if constexpr (Record<Value>)
      if (domain.inlined) return read_fields(element, value);
    if (element.has(name) || !domain.optional) read_value(element[name], value, domain);
  });
}

template <SharedRecord Value>
void read_value(const JsonElement& element, Value& value, const Domain& /*domain*/) {
  typename Value::Table table;
  read_record(element, table);
  try {
    value = Value(std::move(table));
  } catch (const InputError& error) {
    element.refuse_as(error.fault(), fmt::format(": {}", error.what()));
  }
}

template <class T>
void read_value(const JsonElement& element, std::vector<T>& list, const Domain& domain) {
  if (!element.is_list()) element.refuse(InputFault::malformed_file, "is not a list");
  list.resize(element.size());
  for (std::size_t i = 0; i < list.size(); ++i) read_value(element.at(i), list[i], domain);
}

template <class T>
void read_value(const JsonElement& element, std::optional<T>& value, const Domain& domain) {
  read_value(element, value.emplace(), domain);
}

template <class... Ts>
void read_value(const JsonElement& element, std::variant<Ts...>& value, const Domain& /*domain*/) {
  static const std::vector<std::string> names{Ts::name...};
  const std::size_t index = index_among(element["kind"], names);
  std::size_t i = 0;
  ((i++ == index ? read_record(element, value.template emplace<Ts>(), {"kind"}) : void()), ...);
}

} // namespace lightcuts::oracle
