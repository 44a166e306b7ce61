// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

/// A record is a plain struct that lists its fields; in the order in which they are declared, if it
/// is to be written as C++:
///
///   struct Cone {
///     glm::vec3 axis{0, 0, 1};
///     float angle = 0;
///
///     template <class Visitor>
///     static constexpr void fields(Visitor&& field) {
///       field("axis", &Cone::axis, domain::unit);
///       field("angle", &Cone::angle, domain::within(0, 180));
///     }
///   };
///
/// Whatever reads, writes, compares or simplifies records does so for all of them by that list. A
/// field is a number, truth value, text, GLM vector, enum or choice with names, record, variant of
/// records that have a `name` each, shared record, or a std::vector or std::optional of such.
namespace lightcuts {

/// Where the values of a field lie; of a vector, each of its components.
struct Domain {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool unit = false;     ///< a vector of length 1
  bool optional = false; ///< may be left out where it has its default value; default false
  bool inlined = false;  ///< a record whose fields stand in its place in texts; default false
  bool exists = true;    ///< false: the record's other fields make it mean nothing; default true
};

namespace domain {

inline constexpr Domain any{};
inline constexpr Domain not_negative{.least = 0};
inline constexpr Domain unit{.unit = true};
inline constexpr Domain optional{.optional = true};
inline constexpr Domain inlined{.inlined = true};
inline constexpr Domain absent{.exists = false};
[[nodiscard]] constexpr Domain within(double least, double most) {
  return {.least = least, .most = most};
}

} // namespace domain

/// One field of the record R: its name, `Value R::*member`, and its domain, which may depend on the
/// fields before it: then D is a function of the record.
template <class R, class Value, class D>
struct Field {
  const char* name;
  Value R::*member;
  D domain;

  [[nodiscard]] constexpr Domain domain_in(const R& record) const {
    if constexpr (std::is_invocable_v<D, const R&>)
      return domain(record);
    else
      return domain;
  }
};

namespace detail {

struct AnyField {
  template <class... Ts>
  constexpr void operator()(Ts&&... /*field*/) const {}
};

} // namespace detail

template <class R>
concept Record = requires {
  std::remove_const_t<R>::fields(detail::AnyField{});
};

/// A value that gives its record, a T::Table, by table(), and is made of one, unless it throws
/// InputError: the record is large, and copies share it.
template <class T>
concept SharedRecord = Record<typename T::Table> && std::is_constructible_v<T, typename T::Table> &&
    requires(const T& value) {
  { value.table() } -> std::convertible_to<const typename T::Table&>;
};

/// Calls f(Field) for each field that such a record can have.
template <Record R, class F>
constexpr void for_each_field(F&& f) {
  R::fields([&f]<class Value, class D = Domain>(const char* name, Value R::*member, D domain = {}) {
    f(Field<R, Value, D>{name, member, domain});
  });
}

/// Calls f(name, value, Domain) for each field that the record has.
template <Record R, class F>
constexpr void for_each_field(R& record, F&& f) {
  for_each_field<std::remove_const_t<R>>([&](const auto& field) {
    if (const Domain domain = field.domain_in(record); domain.exists)
      f(field.name, record.*field.member, domain);
  });
}

/// Calls f(name, value, value of the same field of `other`, Domain) for each field of `record`.
template <Record R, class F>
constexpr void for_each_field(R& record, const std::type_identity_t<R>& other, F&& f) {
  for_each_field<std::remove_const_t<R>>([&](const auto& field) {
    if (const Domain domain = field.domain_in(record); domain.exists)
      f(field.name, record.*field.member, other.*field.member, domain);
  });
}

/// How many fields the record lists.
template <Record R>
[[nodiscard]] constexpr std::size_t field_count() {
  std::size_t count = 0;
  for_each_field<R>([&count](const auto& /*field*/) { ++count; });
  return count;
}

/// An enum whose values, from 0 on, have the names that names_of(any of them), an array beside it,
/// gives: those of files and reports, and with `_` for `-` also those of the source.
template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires(Enum value) {
  names_of(value).size();
};

template <NamedEnum Enum>
[[nodiscard]] constexpr const char* name_of(Enum value) {
  return names_of(value)[std::size_t(value)];
}

/// The value of that name, if there is one.
template <NamedEnum Enum>
[[nodiscard]] constexpr std::optional<Enum> value_named(std::string_view name) {
  for (std::size_t i = 0; i < names_of(Enum{}).size(); ++i)
    if (name == names_of(Enum{})[i]) return Enum(i);
  return std::nullopt;
}

/// A type that is no enum, but stands for one of several things with names: name_of(value), beside
/// it, is that of files and reports, and values_of(std::type_identity of it) an array of them all.
template <class T>
concept NamedChoice = !std::is_enum_v<T> && requires(const T& value) {
  { name_of(value) } -> std::convertible_to<const char*>;
  values_of(std::type_identity<T>{}).size();
};

/// The value of that name, if there is one.
template <NamedChoice Choice>
[[nodiscard]] constexpr std::optional<Choice> value_named(std::string_view name) {
  for (const Choice& value : values_of(std::type_identity<Choice>{}))
    if (name == name_of(value)) return value;
  return std::nullopt;
}

} // namespace lightcuts
