// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/records/fields.h>
#include <oracle/cases/simpler.h>
#include <oracle/records/kinds_of_value.h>

namespace lightcuts::oracle {

[[nodiscard]] std::vector<float> simpler_values(float value, float usual, const Domain& domain);
[[nodiscard]] std::vector<glm::vec3> simpler_values(const glm::vec3& value, const glm::vec3& usual,
                                                    const Domain& domain);
[[nodiscard]] std::vector<glm::uvec2> simpler_values(const glm::uvec2& value,
                                                     const glm::uvec2& usual, const Domain& domain);
/// With fewer elements, at least so many: the fewest first.
template <class T>
[[nodiscard]] std::vector<std::vector<T>> with_fewer(const std::vector<T>& value,
                                                     std::size_t least) {
  std::vector<std::vector<T>> list;
  for (std::size_t chunk = value.size(); chunk > 0; chunk /= 2)
    for (std::size_t first = 0; first + chunk <= value.size(); first += chunk) {
      if (value.size() - chunk < least) break;
      list.push_back(value);
      const auto begin = list.back().begin() + std::ptrdiff_t(first);
      list.back().erase(begin, begin + std::ptrdiff_t(chunk));
    }
  return list;
}

[[nodiscard]] std::vector<std::vector<std::uint32_t>>
simpler_values(const std::vector<std::uint32_t>& value, const std::vector<std::uint32_t>& usual,
               const Domain& domain);

[[nodiscard]] std::vector<std::vector<Light>> simpler_values(const std::vector<Light>& value,
                                                             const std::vector<Light>& usual,
                                                             const Domain& domain);

/// Alike everywhere, in all half-planes, or with fewer vertical angles or rounder shares.
[[nodiscard]] std::vector<Profile> simpler_values(const Profile& value, const Profile& usual,
                                                  const Domain& domain);

/// Copies of the record that differ from it by one field's being as `usual` has it.
template <Record R>
[[nodiscard]] std::vector<R> with_usual_fields(const R& record, const R& usual) {
  std::vector<R> list;
  R copy = record;
  for_each_field(copy, usual, [&](const char*, auto& field, const auto& value, Domain) {
    if (field == value) return;
    auto kept = std::exchange(field, value);
    list.push_back(copy);
    field = std::move(kept);
  });
  return list;
}

/// Values of the domain that are simpler, the simplest first; none for the simplest of all. Of a
/// record, those with one field simpler; whole numbers and truth values turn into the usual one;
/// enums stay, since what they mean to other fields is not known here.
template <class Value>
[[nodiscard]] std::vector<Value> simpler_values(const Value& value, const Value& usual = {},
                                                const Domain& /*domain*/ = {}) {
  std::vector<Value> list;
  if constexpr (Record<Value>) {
    Value copy = value;
    for_each_field(copy, usual,
                   [&](const char*, auto& field, const auto& usual_field, const Domain& domain) {
                     const auto kept = field;
                     for (const auto& simpler : simpler_values(kept, usual_field, domain)) {
                       field = simpler;
                       list.push_back(copy);
                     }
                     field = kept;
                   });
  } else if constexpr (is_variant<Value>) {
    if (value.index() != 0) list.emplace_back();
    std::visit(
        [&list](const auto& alternative) {
          for (const auto& simpler : simpler_values(alternative)) list.emplace_back(simpler);
        },
        value);
  } else if constexpr (std::is_integral_v<Value>) {
    if (value != usual) list.push_back(usual);
  } else {
    static_assert(std::is_enum_v<Value>);
  }
  return list;
}

} // namespace lightcuts::oracle
