// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/records/fields.h>
#include <oracle/numbers/dice.h>
#include <oracle/records/bits.h>
#include <oracle/records/kinds_of_value.h>

/// For tests of what reads, writes or changes records: that no field is left out.
namespace lightcuts {

/// Sets every field, of records in records too, to a value of its domain that is unlike its
/// default, with all its bits in use. Lists become long enough for every value of an enum and every
/// alternative of a variant to stand somewhere.
class Unlike {
public:
  template <class Value>
  void operator()(Value& value, const Value& usual = {}, const Domain& domain = {}) {
    if constexpr (Record<Value>)
      set_fields(value, usual);
    else
      do set(value, domain);
      while (oracle::same_bits(value, usual) && !has_shapes<Value>);
  }

private:
  static constexpr std::size_t most_shapes = 5;
  template <class Value>
  static constexpr bool has_shapes = NamedEnum<Value> || oracle::is_variant<Value>;

  template <class R>
  void set_fields(R& record, const R& usual) {
    for_each_field(record, usual,
                   [this](const char*, auto& value, const auto& usual_value, const Domain& domain) {
                     (*this)(value, usual_value, domain);
                   });
    if constexpr (std::is_same_v<R, Light>)
      if (record.cos_inner < record.cos_outer) std::swap(record.cos_inner, record.cos_outer);
  }

  template <class Value>
  void set(Value& value, const Domain& domain) {
    if constexpr (NamedEnum<Value>) {
      value = Value(shape_ % names_of(value).size());
    } else if constexpr (oracle::is_variant<Value>) {
      set_alternative(value, std::make_index_sequence<std::variant_size_v<Value>>{});
    } else if constexpr (std::is_same_v<Value, glm::vec3>) {
      for (int i = 0; i < 3; ++i) (*this)(value[i], 0.0F, domain.unit ? Domain{} : domain);
      if (domain.unit) value = glm::vec3(glm::normalize(glm::dvec3(value)));
    } else if constexpr (oracle::is_glm_vector<Value>) {
      for (int i = 0; i < Value::length(); ++i) (*this)(value[i], {}, domain);
    } else if constexpr (oracle::is_optional<Value>) {
      (*this)(value.emplace(), {}, domain);
    } else if constexpr (std::is_same_v<Value, Profile>) {
      value = Profile(unlike_table());
    } else if constexpr (NamedChoice<Value>) {
      const auto values = values_of(std::type_identity<Value>{});
      value = values[dice_.bits() % values.size()];
    } else if constexpr (std::is_same_v<Value, std::string>) {
      value = "it \"says\" " + std::to_string(dice_.bits()) + "\n";
    } else if constexpr (std::is_floating_point_v<Value>) {
      value = Value(dice_.uniform(std::max(domain.least, -2.0), std::min(domain.most, 2.0)));
    } else if constexpr (std::is_same_v<Value, bool>) {
      value = !value;
    } else if constexpr (std::is_integral_v<Value>) {
      value = whole<Value>(domain);
    } else {
      set_list(value);
    }
  }

  /// One whose parts go together.
  ProfileTable unlike_table() {
    const auto share = [this] { return float(dice_.uniform(0, 1)); };
    const float half = float(dice_.uniform(-0.6, -0.4));
    const float sine = float(std::sqrt(1 - double(half) * half));
    return {.cosines = {1, share(), -1},
            .plane_cosines = {1, half, half},
            .plane_sines = {0, sine, -sine},
            .shares = {share(), share(), share(), share(), share(), share(), share(), share(),
                       share()}};
  }

  template <class Integer>
  Integer whole(const Domain& domain) {
    const auto least = std::uint64_t(std::max(domain.least, 0.0));
    const bool bounded = domain.most < 0x1p64;
    const std::uint64_t bits = dice_.bits();
    return Integer(bounded ? least + bits % (std::uint64_t(domain.most) - least + 1) : bits);
  }

  template <class Variant, std::size_t... i>
  void set_alternative(Variant& value, std::index_sequence<i...> /*alternatives*/) {
    ((i == shape_ % sizeof...(i) ? (*this)(value.template emplace<i>()) : void()), ...);
  }

  /// Numbers are indices into a list that is made so, too.
  void set_list(std::vector<std::uint32_t>& indices) { indices = {0, 2, 3}; }

  template <class T>
  void set_list(std::vector<T>& list) {
    list = std::vector<T>(most_shapes);
    for (shape_ = 0; shape_ < list.size(); ++shape_) (*this)(list[shape_]);
    shape_ = 1;
  }

  gen::Dice dice_{1};
  std::size_t shape_ = 1;
};

template <class R>
[[nodiscard]] R unlike_default() {
  R record;
  Unlike{}(record);
  return record;
}

/// The bits of each field that is no record, by its path: "views/0/material/lobe/phong/exponent".
template <class Value>
void append_leaves(std::map<std::string, std::vector<std::uint64_t>>& leaves,
                   const std::string& path, const Value& value) {
  if constexpr (Record<Value>) {
    for_each_field(value, [&](const std::string& name, const auto& part, const Domain&) {
      append_leaves(leaves, path.empty() ? name : path + "/" + name, part);
    });
  } else if constexpr (oracle::is_variant<Value>) {
    std::visit([&](const auto& part) { append_leaves(leaves, path + "/" + part.name, part); },
               value);
  } else if constexpr (oracle::is_vector<Value> &&
                       !std::is_same_v<Value, std::vector<std::uint32_t>>) {
    for (std::size_t i = 0; i < value.size(); ++i)
      append_leaves(leaves, path + "/" + std::to_string(i), value[i]);
  } else {
    leaves[path] = oracle::bits_of(value);
  }
}

template <class R>
[[nodiscard]] std::map<std::string, std::vector<std::uint64_t>> leaves_of(const R& record) {
  std::map<std::string, std::vector<std::uint64_t>> leaves;
  append_leaves(leaves, "", record);
  return leaves;
}

} // namespace lightcuts
