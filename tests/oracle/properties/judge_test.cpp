// SPDX-License-Identifier: MIT
#include <oracle/properties/judge.h>

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <oracle/cases/random_case.h>
#include <oracle/mutants/mutants.h>
#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr std::uint64_t with_draws = 2999; // index of a random case, one of few draws

/// The library's tree, but for a part that it must not be asked for.
class Without : public LibraryTree {
public:
  Without(const LightTree& tree, Part part) : LibraryTree(tree), missing_(part) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<Without>(*this);
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return ask(Part::bounds).LibraryTree::bound(node, point);
  }
  glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point) override {
    return ask(Part::lower_bounds).LibraryTree::lower_bound(node, point);
  }
  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    return ask(Part::estimates).LibraryTree::estimate(node, point, bound);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    return ask(Part::cuts).LibraryTree::select(point, config, visible);
  }
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    return ask(Part::sampling).LibraryTree::sample(node, point, u);
  }
  std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                    std::span<const std::uint32_t> lights) override {
    return ask(Part::sampling).LibraryTree::probabilities(node, point, lights);
  }
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    return ask(Part::random_cuts).LibraryTree::draw(point, config, query, visible);
  }

private:
  Without& ask(Part part) {
    if (part == missing_) throw std::logic_error(name_of(part));
    return *this;
  }

  Part missing_;
};

TEST(Judge, AsksForPartsThatThereAreOnly) {
  for (const Part part : {Part::bounds, Part::lower_bounds, Part::estimates, Part::cuts,
                          Part::sampling, Part::random_cuts}) {
    const MadeSubject subject(
        [part](LightTree tree) { return std::make_unique<Without>(tree, part); },
        all_parts_and_claims & ~only(part));
    Tally tally;
    for (std::uint64_t i = 0; i < 40; ++i) check_case(subject, random_case(1, i), i, tally);
    check_case(subject, random_case(1, with_draws), with_draws, tally);
    for (const Property p : all_properties) {
      if (!has(info(p).needs, part)) continue;
      EXPECT_EQ(tally[p].cases, 0U) << info(p).name;
    }
  }
}

TEST(Judge, CountsAPropertyAloneAsAllTogether) {
  for (const char* name : {"heap-inverted", "zero-times-infinity", "inverse-probability"}) {
    const Mutant* mutant = mutant_named(name);
    ASSERT_NE(mutant, nullptr) << name;
    const auto subject = mutant->subject();
    for (const std::uint64_t i : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, unsigned(with_draws)}) {
      const Case on = random_case(1, i);
      Tally all;
      check_case(*subject, on, i, all);
      for (const Property p : all_properties) {
        Tally one;
        check_case(*subject, on, i, one, p);
        EXPECT_EQ(one[p], all[p]) << name << ": " << info(p).name << " in case " << i;
      }
    }
  }
}

} // namespace
} // namespace lightcuts::oracle
