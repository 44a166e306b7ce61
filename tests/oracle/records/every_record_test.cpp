// SPDX-License-Identifier: MIT
#include <oracle/records/record_json.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/cases/case_text.h>
#include <oracle/cases/simpler_case.h>
#include <oracle/counterexamples/as_test.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/records/record_literal.h>
#include <tests/support/every_field.h>
#include <tests/support/member_count.h>

namespace lightcuts::oracle {
namespace {

using testing::IsEmpty;

template <class R>
class EveryRecord : public testing::Test {};

using Records = testing::Types<Light, ProfileTable, NoLobe, Phong, Ward, CookTorrance, Material,
                               CutConfig, Camera, gen::View, gen::Scene, CaseView, CaseTriangle,
                               Case, Counterexample, SavedCounterexample>;
TYPED_TEST_SUITE(EveryRecord, Records);

TYPED_TEST(EveryRecord, ListsAllItsMembers) {
  EXPECT_EQ(field_count<TypeParam>(), member_count<TypeParam>());
}

// Records in this one, and of each kind or alternative one, have all their fields in it.
const SavedCounterexample& saved() {
  static const auto all = unlike_default<SavedCounterexample>();
  return all;
}
const Case& filled() { return saved().counterexample.on; }

TEST(UnlikeDefault, IsSoInEveryField) {
  const auto leaves = leaves_of(filled());
  for (const char* path :
       {"lights/0/position", "lights/1/axis", "lights/2/cos_outer", "lights/3/intensity",
        "lights/4/plane", "lights/4/profile", "views/1/view/material/lobe/phong/exponent",
        "views/2/view/material/lobe/ward/alpha", "views/3/view/material/lobe/cook-torrance/f0",
        "views/0/hidden", "cut/unoccluded", "draws", "builds", "questions", "triangles/1/mesh",
        "camera/up", "image_size"})
    EXPECT_EQ(leaves.count(path), 1U) << path;
  EXPECT_EQ(leaves.size(), 5 * 3 + 3 + 4 + 5 * 5 + 6 + 4 + 5 * 4 + 4 + 6U);
  const auto usual = leaves_of(Case{});
  for (const auto& [path, bits] : usual) EXPECT_NE(leaves.at(path), bits) << path;
}

TEST(EveryField, IsKeptByJson) {
  const std::string text = counterexample_json(saved());
  const SavedCounterexample read = read_counterexample("a.json", text);
  EXPECT_EQ(leaves_of(read), leaves_of(saved()));
  EXPECT_TRUE(same_bits(read, saved()));
  EXPECT_EQ(counterexample_json(read), text);
}

Case case_of_literal() {
#include <tests/oracle/records/every_field.inc>
  return on;
}

TEST(EveryField, IsKeptByStatementsOfCpp) {
  std::ifstream file(LIGHTCUTS_EVERY_FIELD);
  const std::string compiled(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(statements_for(filled()), compiled);
  EXPECT_EQ(leaves_of(case_of_literal()), leaves_of(filled()));
}

TEST(EveryField, IsInTheText) {
  std::istringstream words(text_of(filled()));
  std::string text, word;
  while (words >> word) text += word + " ";
  for (const auto& [path, bits] : leaves_of(filled())) {
    std::string name = path.substr(path.rfind('/') + 1);
    std::replace(name.begin(), name.end(), '_', ' ');
    if (path.find('/') == std::string::npos) name += ":";
    if (name == "kind") continue; // goes without its name
    EXPECT_NE(text.find(" " + name + " "), std::string::npos) << path;
  }
}

TEST(EveryField, ChangesTheFingerprint) {
  std::set<std::uint64_t> all{fingerprint(filled())};
  std::size_t changes = 0;
  for_each_field<Case>([&](const auto& field) {
    Case changed = filled();
    changed.*field.member = Case{}.*field.member;
    all.insert(fingerprint(changed));
    ++changes;
  });
  EXPECT_EQ(all.size(), changes + 1);
}

// But for the camera, which stays, and kinds, which take other fields with them.
TEST(EveryField, GetsSimpler) {
  const auto leaves = leaves_of(filled());
  std::set<std::string> left;
  for (const auto& [path, bits] : leaves)
    if (!path.starts_with("camera") && !path.ends_with("kind")) left.insert(path);
  visit_simpler(filled(), [&](const Case& simpler) {
    for (const auto& [path, bits] : leaves_of(simpler))
      if (const auto was = leaves.find(path); was != leaves.end() && was->second != bits)
        left.erase(path);
    return false;
  });
  EXPECT_THAT(left, IsEmpty());
}

} // namespace
} // namespace lightcuts::oracle
