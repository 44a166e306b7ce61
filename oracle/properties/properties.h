// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <oracle/properties/description.h>

namespace lightcuts::oracle {

/// What the oracle checks: an index into the table of descriptions. Its order is that of reports.
enum class Property : std::uint8_t {
#define LIGHTCUTS_ENUMERATOR(name) name,
  LIGHTCUTS_PROPERTIES(LIGHTCUTS_ENUMERATOR)
#undef LIGHTCUTS_ENUMERATOR
};

#define LIGHTCUTS_LISTED(name) Property::name,
inline constexpr std::array all_properties{LIGHTCUTS_PROPERTIES(LIGHTCUTS_LISTED)};
#undef LIGHTCUTS_LISTED
inline constexpr std::size_t property_count = all_properties.size();

[[nodiscard]] const PropertyInfo& info(Property property);
/// The names of all properties, in their order: for the fields of records.
[[nodiscard]] std::array<const char*, property_count> names_of(Property any);
[[nodiscard]] std::optional<Property> property_named(std::string_view name);

/// Whether it is a violation or a waste that a subject of such parts and claims breaks the
/// property.
[[nodiscard]] Severity severity_of(Property property, Parts parts);

/// Counts of one property.
struct PropertyCount {
  std::uint64_t cases = 0;
  std::uint64_t violations = 0;
  Severity severity = Severity::violation; ///< of the violations
  /// Largest left side / right side of the formula; 1 is the limit. Negative: a yes-or-no property.
  double worst_ratio = -1;
  /// Says of the violation found at the lowest place where it is, and the values on both sides.
  std::string first_violation;
  std::uint64_t first_place = std::numeric_limits<std::uint64_t>::max();

  /// Counts one case. place orders violations (the index of a shading point, say); describe() is
  /// called for a violation that becomes the first one.
  template <class Describe>
  void record(bool holds, std::uint64_t place, double ratio, Describe&& describe) {
    hold(1, ratio);
    if (holds) return;
    ++violations;
    if (place >= first_place) return;
    first_place = place;
    first_violation = describe();
  }
  /// Counts cases that hold, of which the worst has this ratio.
  void hold(std::uint64_t so_many, double ratio) {
    cases += so_many;
    if (!(ratio <= worst_ratio)) worst_ratio = ratio;
  }
  void merge(const PropertyCount& other);

  bool operator==(const PropertyCount&) const = default;
};

/// For record(): properties that hold or not, without a ratio.
inline constexpr double no_ratio = -1;

/// Where a check of one property at one place counts its cases.
class Recorder {
public:
  Recorder(PropertyCount& count, std::uint64_t place, Severity severity = Severity::violation)
      : count_(count), place_(place), severity_(severity) {}

  /// See PropertyCount::record().
  template <class Describe>
  void operator()(bool holds, double ratio, Describe&& describe) const {
    if (!holds) count_.severity = severity_;
    count_.record(holds, place_, ratio, std::forward<Describe>(describe));
  }
  /// For properties that hold or not, without a ratio.
  template <class Describe>
  void operator()(bool holds, Describe&& describe) const {
    (*this)(holds, no_ratio, std::forward<Describe>(describe));
  }

private:
  PropertyCount& count_;
  std::uint64_t place_;
  Severity severity_;
};

/// The counts of all properties. Merging is commutative, so the order of threads does not show.
class Tally {
public:
  [[nodiscard]] PropertyCount& operator[](Property p) { return counts_[std::size_t(p)]; }
  [[nodiscard]] const PropertyCount& operator[](Property p) const {
    return counts_[std::size_t(p)];
  }
  void merge(const Tally& other);
  /// Sums over the properties of that severity.
  [[nodiscard]] std::uint64_t violations() const { return sum(Severity::violation); }
  [[nodiscard]] std::uint64_t wasteful() const { return sum(Severity::waste); }

  bool operator==(const Tally&) const = default;

private:
  [[nodiscard]] std::uint64_t sum(Severity severity) const;

  std::array<PropertyCount, property_count> counts_;
};

/// The properties that do not hold, violations before waste.
[[nodiscard]] std::vector<Property> broken(const Tally& tally);

/// left / right for record(): 0/0 is 0, x/0 and NaN are the largest double, which JSON can say.
[[nodiscard]] inline double ratio_of(long double left, long double right) {
  if (left == 0 && right >= 0) return 0;
  constexpr double largest = std::numeric_limits<double>::max();
  const long double ratio = left / right;
  if (!(ratio >= 0) || ratio > largest) return largest;
  return static_cast<double>(ratio);
}

} // namespace lightcuts::oracle
