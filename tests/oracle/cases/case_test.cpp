// SPDX-License-Identifier: MIT
#include <oracle/cases/case.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/simpler_case.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/view/scene_view.h>
#include <tests/oracle/support/case_text.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_unit(const glm::vec3& v) { return std::abs(glm::length(glm::dvec3(v)) - 1) <= 1e-5; }

/// LightSet::add() takes a light's word for it.
bool is_valid(const Light& light) {
  if (!is_finite(light.position) || !is_finite(light.intensity)) return false;
  if (glm::any(glm::lessThan(light.intensity, glm::vec3(0)))) return false;
  if (light.kind == LightKind::directional && !is_unit(light.position)) return false;
  if ((only(light.kind) & kinds_with_axis) != 0 && !is_unit(light.axis)) return false;
  if (light.kind == LightKind::profile && !is_unit(light.plane)) return false;
  return light.kind != LightKind::spot ||
         (light.cos_inner <= 1 && light.cos_outer >= -1 && light.cos_inner > light.cos_outer);
}

/// What is wrong with the case, or nothing.
std::string fault_of(const Case& c) {
  try {
    if (c.lights.empty()) return "no lights";
    if (c.views.empty()) return "no views";
    if (!std::all_of(c.lights.begin(), c.lights.end(), is_valid)) return "a light is not valid";
    (void)c.light_set();
    validate(c.cut);
    for (const CaseView& v : c.views) {
      (void)v.view.point();
      if (!std::is_sorted(v.hidden.begin(), v.hidden.end())) return "hidden lights not ascending";
      if (std::adjacent_find(v.hidden.begin(), v.hidden.end()) != v.hidden.end())
        return "a light hidden twice";
      if (!v.hidden.empty() && v.hidden.back() >= c.lights.size()) return "no such light is hidden";
    }
    if (c.triangles.empty()) return "";
    const Scene scene = c.scene();
    if (SceneView(scene).size() != c.image_size) return "another size";
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(RandomCase, IsValid) {
  for (std::uint64_t i = 0; i < 3000; ++i) EXPECT_EQ(fault_of(random_case(7, i)), "") << i;
}

TEST(RandomCase, IsTheSameForTheSameSeedAndIndexOnly) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
    for (std::uint64_t i = 0; i < 200; ++i) {
      const std::string text = text_of(random_case(seed, i));
      EXPECT_EQ(text, text_of(random_case(seed, i)));
      texts.insert(text);
    }
  EXPECT_EQ(texts.size(), 400U);
}

// Of 3000 cases; that of the rarest has to be common enough for a hunt to meet it soon.
TEST(RandomCase, HasAllThatLightsAndSurfacesCanBe) {
  std::map<std::string, int> met;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Case c = random_case(1, i);
    LightKinds kinds = 0;
    for (const Light& light : c.lights) {
      kinds |= only(light.kind);
      ++met["kind " + std::to_string(int(light.kind))];
    }
    met["mixed"] += (kinds & (kinds - 1)) != 0 ? 1 : 0;
    for (const CaseView& v : c.views) {
      ++met["lobe " + std::to_string(v.view.material.lobe.index())];
      met["hidden"] += !v.hidden.empty() ? 1 : 0;
      met["all hidden"] += v.hidden.size() == c.lights.size() ? 1 : 0;
    }
    ++met[std::to_string(c.views.size()) + " views"];
    met["clamped"] += c.min_distance > 0 ? 1 : 0;
    met["picture"] += !c.triangles.empty() ? 1 : 0;
    met["black level"] += c.cut.black_level > 0 ? 1 : 0;
    met["small cut"] += c.cut.max_size < c.lights.size() ? 1 : 0;
    met["one light"] += c.lights.size() == 1 ? 1 : 0;
    met["many lights"] += c.lights.size() > 16 ? 1 : 0;
  }
  EXPECT_EQ(met.size(), 23U);
  for (const auto& [what, times] : met) EXPECT_GT(times, 50) << what;
}

TEST(CaseScene, HasTheTrianglesLightsAndMaterialOfTheCase) {
  Case c;
  c.lights.resize(2);
  c.lights[1].intensity = glm::vec3(3);
  c.min_distance = 0.5F;
  c.views.push_back({});
  c.views[0].view.material = {glm::vec3(0.25F), {}};
  const glm::vec3 a(0), b(1, 0, 0), d(0, 0, 1);
  c.triangles = {{a, b, d, 0}, {b, d, a, 2}};
  c.image_size = {3, 5};
  const Scene scene = c.scene();
  EXPECT_EQ(scene.mesh.triangles.size(), 2U);
  EXPECT_THAT(scene.mesh.positions, ElementsAre(a, b, d, b, d, a));
  EXPECT_THAT(scene.mesh.surface, ElementsAre(0, 2));
  ASSERT_EQ(scene.surfaces.size(), 3U);
  EXPECT_EQ(scene.surfaces[2].material.diffuse, glm::vec3(0.25F));
  EXPECT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[1].intensity, glm::vec3(3));
  EXPECT_EQ(scene.lights.min_distance(), 0.5F);
  EXPECT_EQ(scene.image_size, glm::uvec2(3, 5));
}

TEST(SimplerCases, AreValidAndOthers) {
  for (std::uint64_t i = 0; i < 25; ++i) {
    const Case c = random_case(3, i);
    const std::string text = text_of(c);
    for (const Case& s : simpler(c)) {
      ASSERT_EQ(fault_of(s), "") << i;
      ASSERT_NE(text_of(s), text) << i;
    }
  }
}

/// The end of a walk from case to simpler case, each picked by `pick` of so many.
template <class Pick>
Case walked_down(Case c, Pick&& pick) {
  for (int steps = 0; steps < 5000; ++steps) {
    std::vector<Case> list = simpler(c);
    if (list.empty()) return c;
    c = list[pick(list.size())];
  }
  ADD_FAILURE() << "no end";
  return c;
}

void expect_simplest(const Case& c) {
  ASSERT_EQ(c.lights.size(), 1U);
  EXPECT_EQ(c.lights[0].intensity, glm::vec3(0));
  ASSERT_EQ(c.views.size(), 1U);
  EXPECT_EQ(c.views[0].view.position, glm::vec3(0));
  EXPECT_EQ(c.views[0].view.normal, glm::vec3(0, 0, 1));
  EXPECT_THAT(c.views[0].hidden, IsEmpty());
  EXPECT_LE(c.triangles.size(), 1U);
  EXPECT_EQ(c.min_distance, 0);
  EXPECT_EQ(c.seed, 1U);
  EXPECT_EQ(c.cut, (CutConfig{0.02F, 1000, 0}));
}

TEST(SimplerCases, LeadToTheSimplestOfAllWhateverIsPicked) {
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Case c = random_case(4, i);
    gen::Dice dice(i);
    expect_simplest(walked_down(c, [](std::size_t) { return 0; }));
    expect_simplest(walked_down(c, [](std::size_t count) { return count - 1; }));
    expect_simplest(
        walked_down(c, [&](std::size_t count) { return std::size_t(dice.below(int(count))); }));
  }
}

// Each light has an intensity of its own to be known by.
TEST(SimplerCases, HideTheSameLightsAsBefore) {
  Case c;
  for (int i = 0; i < 7; ++i) {
    c.lights.emplace_back();
    c.lights.back().intensity = glm::vec3(float(i + 2), 0, 0);
  }
  c.views.resize(2);
  c.views[0].hidden = {0, 3, 4, 6};
  c.views[1].hidden = {2};
  int fewer = 0;
  for (const Case& s : simpler(c)) {
    if (s.lights.size() == c.lights.size()) continue;
    ++fewer;
    std::vector<float> left;
    for (const Light& light : s.lights) left.push_back(light.intensity.x);
    for (std::size_t v = 0; v < 2; ++v) {
      std::vector<float> hidden, expected;
      for (const std::uint32_t light : s.views[v].hidden)
        hidden.push_back(s.lights[light].intensity.x);
      for (const std::uint32_t light : c.views[v].hidden) {
        const float x = c.lights[light].intensity.x;
        if (std::find(left.begin(), left.end(), x) != left.end()) expected.push_back(x);
      }
      EXPECT_EQ(hidden, expected);
    }
  }
  EXPECT_GE(fewer, 9); // two chunks of three, and each light
}

TEST(SimplerCases, HaveFewerLightsFirst) {
  Case c;
  c.lights.resize(8);
  c.views.resize(1);
  EXPECT_EQ(simpler(c).front().lights.size(), 4U);
}

TEST(SimplerCases, LeaveOneOfTwoLightsToChooseFrom) {
  Case c;
  c.lights.resize(2);
  c.lights[0].intensity.x = 1;
  c.views.resize(1);
  std::vector<float> left;
  for (const Case& s : simpler(c))
    if (s.lights.size() == 1) left.push_back(s.lights[0].intensity.x);
  EXPECT_THAT(left, ElementsAre(0, 1));
}

// Next to powers of 2 and 10: above them first.
TEST(RandomCase, HasManyLightsOfTellingNumbers) {
  std::vector<std::uint32_t> numbers;
  for (std::uint64_t i = 0; i < 4000; ++i)
    if (const std::uint32_t many = many_lights_at(i)) numbers.push_back(many);
  EXPECT_EQ(*std::is_sorted_until(numbers.begin(), numbers.end()), 127U);
  EXPECT_EQ(*(std::is_sorted_until(numbers.begin(), numbers.end()) - 1), 16385U);
  for (const std::uint32_t number : {100U, 1023U, 1024U, 1025U, 65537U, 100'000U, 131073U})
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), number), 1) << number;
  for (std::uint64_t i = 0; i < 1200; ++i) {
    const std::uint32_t many = many_lights_at(i);
    if (many == 0) continue;
    EXPECT_EQ(random_case(1, i).lights.size(), many);
  }
}

TEST(RandomCase, HasHistoriesOfAllLengths) {
  std::map<std::uint32_t, int> questions;
  int builds = 0, shared_position = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Case c = random_case(1, i);
    if (c.questions > 0) {
      ++questions[c.questions];
      shared_position += c.views.front().view.position == c.views.back().view.position ? 1 : 0;
    }
    builds += c.builds > 0 ? 1 : 0;
  }
  EXPECT_GT(questions[256], 5);
  EXPECT_EQ(questions[1U << 16], 1);
  EXPECT_GT(questions.size(), 10U);
  EXPECT_GT(builds, 10);
  EXPECT_GT(shared_position, 10);
}

TEST(RandomCase, SaysThatNothingOccludesInSomeThatHideNothing) {
  int unoccluded = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Case on = random_case(1, i);
    if (!on.cut.unoccluded) continue;
    ++unoccluded;
    EXPECT_TRUE(on.triangles.empty());
    for (const CaseView& view : on.views) EXPECT_TRUE(view.hidden.empty());
  }
  EXPECT_GT(unoccluded, 50);
}

} // namespace
} // namespace lightcuts::oracle
