// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <lightcuts/core/numerics/splitmix.h>
#include <lightcuts/core/records/fields.h>
#include <oracle/records/kinds_of_value.h>

namespace lightcuts::oracle {

/// Appends all that the value is, number by number: of a record, the fields that it has.
template <class Value>
void append_bits(std::vector<std::uint64_t>& bits, const Value& value) {
  if constexpr (Record<Value>) {
    for_each_field(value, [&](const char*, const auto& part, Domain) { append_bits(bits, part); });
  } else if constexpr (SharedRecord<Value>) {
    append_bits(bits, value.table());
  } else if constexpr (is_variant<Value>) {
    bits.push_back(value.index());
    std::visit([&](const auto& alternative) { append_bits(bits, alternative); }, value);
  } else if constexpr (is_vector<Value> || std::is_same_v<Value, std::string>) {
    bits.push_back(value.size());
    for (const auto& element : value) append_bits(bits, element);
  } else if constexpr (is_optional<Value>) {
    bits.push_back(std::uint64_t(value.has_value()));
    if (value) append_bits(bits, *value);
  } else if constexpr (is_glm_vector<Value>) {
    for (int i = 0; i < Value::length(); ++i) append_bits(bits, value[i]);
  } else if constexpr (std::is_same_v<Value, float>) {
    bits.push_back(std::bit_cast<std::uint32_t>(value));
  } else if constexpr (std::is_same_v<Value, double>) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  } else if constexpr (NamedChoice<Value>) {
    append_bits(bits, std::string(name_of(value)));
  } else {
    bits.push_back(static_cast<std::uint64_t>(value));
  }
}

template <class Value>
[[nodiscard]] std::vector<std::uint64_t> bits_of(const Value& value) {
  std::vector<std::uint64_t> bits;
  append_bits(bits, value);
  return bits;
}

/// Whether two values are the same to the bit; 0 and -0 are not.
template <class Value>
[[nodiscard]] bool same_bits(const Value& a, const Value& b) {
  return bits_of(a) == bits_of(b);
}

/// A hash of all that the value is.
template <class Value>
[[nodiscard]] std::uint64_t fingerprint(const Value& value) {
  std::uint64_t hash = 0;
  for (const std::uint64_t word : bits_of(value)) hash = splitmix64(hash ^ word);
  return hash;
}

} // namespace lightcuts::oracle
