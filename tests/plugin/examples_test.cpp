// SPDX-License-Identifier: MIT
#include <tests/plugin/plugins.h>

#include <cstdlib>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <oracle/campaign/check.h>
#include <oracle/campaign/hunt.h>

namespace lightcuts::oracle {
namespace {

struct Example {
  const char* name;
  std::vector<Property> judged; ///< some of the properties that are
  std::vector<std::string> left_out;
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

std::string names(const Tally& tally) {
  std::string names;
  for (const Property p : broken(tally))
    if (tally[p].severity == Severity::violation)
      names += std::string(info(p).name) + ": " + tally[p].first_violation + '\n';
  return names;
}

class Examples : public testing::TestWithParam<Example> {
protected:
  void SetUp() override {
    setenv("PYTHONPATH", LIGHTCUTS_EXAMPLE_SOURCES, 1);
    const bool is_python = GetParam().name == std::string("python_tree");
    if (is_python && dlopen("libpython3.11.so.1.0", RTLD_LAZY) == nullptr)
      GTEST_SKIP() << "no library of Python";
    subject_ = example(GetParam().name);
  }

  std::unique_ptr<Subject> subject_;
};

TEST_P(Examples, OfferTheirParts) {
  EXPECT_THAT(names_without(subject_->parts()), testing::ElementsAreArray(GetParam().left_out));
}

TEST_P(Examples, AreRightOnAScene) {
  Scene scene = open_scene("cloud?lights=20");
  scene.image_size = {16, 12};
  CheckConfig config;
  config.pairs = 1000;
  config.threads = 2;
  const CheckResult result = check(SceneView(scene), *subject_, config);
  EXPECT_EQ(names(result.tally), "");
  for (const Property p : GetParam().judged) EXPECT_GT(result.tally[p].cases, 0U) << info(p).name;
}

TEST_P(Examples, AreRightInRandomCases) {
  HuntConfig config;
  config.cases = 300;
  config.waste = false;
  const HuntResult result = hunt(*subject_, config);
  EXPECT_FALSE(result.found) << result.found->message;
  EXPECT_EQ(result.cases, 300U);
}

constexpr auto upper_bounds = Property::bound_dominates_contribution;
constexpr auto errors = Property::bound_dominates_error;
constexpr auto exact = Property::zero_threshold_is_exact;
constexpr auto sums = Property::probabilities_sum_to_one;
constexpr auto order = Property::refinement_order_is_strict;

INSTANTIATE_TEST_SUITE_P(
    All, Examples,
    testing::Values(Example{"brute_tree",
                            {upper_bounds, errors, exact, sums, order},
                            {"occlusion", "pictures", "random cuts", "block bounds",
                             "lights with profiles", "proven visibility"}},
                    Example{"top_down_tree",
                            {upper_bounds, errors, exact, sums},
                            {"lower bounds", "refinement order", "occlusion", "pictures",
                             "block bounds", "lights with profiles", "proven visibility"}},
                    Example{"bounds_only",
                            {upper_bounds},
                            {"lower bounds", "estimates", "cuts", "sampling", "refinement order",
                             "occlusion", "pictures", "random cuts", "block bounds",
                             "lights with profiles", "proven visibility"}},
                    Example{"new_subject",
                            {upper_bounds, sums},
                            {"lower bounds", "estimates", "cuts", "refinement order", "occlusion",
                             "pictures", "random cuts", "block bounds", "lights with profiles",
                             "proven visibility"}},
                    Example{"python_tree",
                            {upper_bounds},
                            {"lower bounds", "estimates", "cuts", "sampling", "refinement order",
                             "occlusion", "pictures", "random cuts", "block bounds",
                             "lights with profiles", "proven visibility"}}),
    [](const auto& of) { return std::string(of.param.name); });

} // namespace
} // namespace lightcuts::oracle
