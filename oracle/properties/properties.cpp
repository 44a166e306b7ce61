// SPDX-License-Identifier: MIT
#include <oracle/properties/properties.h>

#include <algorithm>

namespace lightcuts::oracle {
namespace {

#define LIGHTCUTS_DESCRIBED(name) &property::name,
constexpr std::array descriptions{LIGHTCUTS_PROPERTIES(LIGHTCUTS_DESCRIBED)};
#undef LIGHTCUTS_DESCRIBED

} // namespace

const PropertyInfo& info(Property property) { return *descriptions[std::size_t(property)]; }

std::array<const char*, property_count> names_of(Property /*any*/) {
  std::array<const char*, property_count> names{};
  for (std::size_t i = 0; i < property_count; ++i) names[i] = info(Property(i)).name;
  return names;
}

Severity severity_of(Property property, Parts parts) {
  const PropertyInfo& of = info(property);
  const bool promised = of.promise == Promise::light_tree || has(parts, Part::library_rules);
  return promised ? of.severity : Severity::waste;
}

std::optional<Property> property_named(std::string_view name) {
  for (const Property p : all_properties)
    if (name == info(p).name) return p;
  return std::nullopt;
}

void PropertyCount::merge(const PropertyCount& other) {
  cases += other.cases;
  if (violations == 0) severity = other.severity;
  violations += other.violations;
  worst_ratio = std::max(worst_ratio, other.worst_ratio);
  if (other.first_place >= first_place) return;
  first_place = other.first_place;
  first_violation = other.first_violation;
}

void Tally::merge(const Tally& other) {
  for (const Property p : all_properties) (*this)[p].merge(other[p]);
}

std::uint64_t Tally::sum(Severity severity) const {
  std::uint64_t sum = 0;
  for (const Property p : all_properties)
    if ((*this)[p].severity == severity) sum += (*this)[p].violations;
  return sum;
}

std::vector<Property> broken(const Tally& tally) {
  std::vector<Property> list;
  for (const Severity severity : {Severity::violation, Severity::waste})
    for (const Property p : all_properties)
      if (tally[p].severity == severity && tally[p].violations > 0) list.push_back(p);
  return list;
}

} // namespace lightcuts::oracle
