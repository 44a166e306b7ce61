// SPDX-License-Identifier: MIT
#include <oracle/properties/properties.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/readme.h>

namespace lightcuts::oracle {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr Property any_property = Property::cut_obeys_threshold;

struct Event {
  Property property;
  bool holds;
  std::uint64_t place;
  double ratio;
};

void record(Tally& tally, const Event& e) {
  tally[e.property].record(e.holds, e.place, e.ratio, [&] { return std::to_string(e.place); });
}

// Each place in one part only, as points are dealt out to threads.
rc::Gen<std::vector<Event>> events(std::uint64_t remainder) {
  return rc::gen::container<std::vector<Event>>(rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(0, int(property_count)), rc::gen::arbitrary<bool>(),
                     rc::gen::inRange<std::uint64_t>(0, 1000), rc::gen::inRange(-1, 5)),
      [remainder](const auto& t) {
        return Event{Property(std::get<0>(t)), std::get<1>(t), 2 * std::get<2>(t) + remainder,
                     double(std::get<3>(t))};
      }));
}

std::ostream& operator<<(std::ostream& out, const Event& e) {
  return out << info(e.property).name << (e.holds ? " holds at " : " fails at ") << e.place;
}

RC_GTEST_PROP(Tally, MergesInAnyOrder, ()) {
  Tally a, b;
  for (const Event& e : *events(0)) record(a, e);
  for (const Event& e : *events(1)) record(b, e);
  Tally ab = a, ba = b;
  ab.merge(b);
  ba.merge(a);
  RC_ASSERT(ab == ba);
  RC_ASSERT(ab.violations() == a.violations() + b.violations());
}

RC_GTEST_PROP(Tally, CountsTheSameInPartsAsInOne, ()) {
  const auto even = *events(0), odd = *events(1);
  Tally whole, a, b;
  for (const Event& e : odd) record(whole, e), record(a, e);
  for (const Event& e : even) record(whole, e), record(b, e);
  b.merge(a);
  RC_ASSERT(whole == b);
}

TEST(Tally, DescribesTheViolationAtTheLowestPlace) {
  Tally tally;
  for (const std::uint64_t place : {5, 3, 9}) record(tally, {any_property, false, place, 1});
  record(tally, {any_property, true, 1, 1});
  EXPECT_EQ(tally[any_property].first_violation, "3");
  EXPECT_EQ(tally[any_property].cases, 4U);
  EXPECT_EQ(tally[any_property].violations, 3U);
}

TEST(Tally, KeepsTheLargestRatio) {
  Tally tally;
  EXPECT_LT(tally[any_property].worst_ratio, 0);
  for (const double ratio : {no_ratio, 0.5, 2.0, 1.0})
    record(tally, {any_property, true, 1, ratio});
  EXPECT_EQ(tally[any_property].worst_ratio, 2);
}

TEST(RatioOf, IsTheQuotient) {
  EXPECT_EQ(ratio_of(1, 4), 0.25);
  EXPECT_EQ(ratio_of(0, 4), 0);
  EXPECT_EQ(ratio_of(4, std::numeric_limits<long double>::infinity()), 0);
}

TEST(RatioOf, IsAlwaysANumberThatJsonCanSay) {
  EXPECT_EQ(ratio_of(0, 0), 0);
  const long double nan = std::nanl("");
  for (const auto& [left, right] : {std::pair{1.0L, 0.0L},
                                    {nan, 1.0L},
                                    {1.0L, nan},
                                    {0.0L, nan},
                                    {1e4000L, 1.0L},
                                    {1.0L, -1.0L}})
    EXPECT_EQ(ratio_of(left, right), largest) << left << " / " << right;
}

TEST(Info, NamesEveryPropertyOnce) {
  std::set<std::string> names;
  for (const Property property : all_properties) {
    const PropertyInfo& p = info(property);
    names.insert(p.name);
    EXPECT_EQ(property_named(p.name), property);
    EXPECT_EQ(std::string(p.statement).back(), '.');
    EXPECT_NE(std::string(p.formula), "");
  }
  EXPECT_EQ(names.size(), property_count);
}

// Tests and files are called what reports are to say.
TEST(Info, NamesPropertiesAsTheTableDoes) {
#define LIGHTCUTS_IDENTIFIER(name) #name,
  const std::array identifiers{LIGHTCUTS_PROPERTIES(LIGHTCUTS_IDENTIFIER)};
#undef LIGHTCUTS_IDENTIFIER
  for (const Property p : all_properties) {
    std::string name = identifiers[std::size_t(p)];
    std::replace(name.begin(), name.end(), '_', '-');
    EXPECT_EQ(info(p).name, name);
  }
}

TEST(Info, StandsInTheReadmesTableInItsOrder) {
  std::string table = "| property | |\n|---|---|\n";
  for (const Property property : all_properties) {
    const PropertyInfo& p = info(property);
    const char* note = p.severity == Severity::waste   ? " (waste)"
                       : p.promise == Promise::library ? " (ours)"
                                                       : "";
    table += fmt::format("| `{}`{} | {} |\n", p.name, note, p.statement);
  }
  EXPECT_NE(test::readme().find(table + "\n"), std::string::npos) << "README.md should have:\n"
                                                                  << table;
}

} // namespace
} // namespace lightcuts::oracle
