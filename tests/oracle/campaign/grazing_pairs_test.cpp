// SPDX-License-Identifier: MIT
#include <oracle/campaign/grazing_pairs.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <lightcuts/core/jobs/seconds_since.h>

namespace lightcuts::oracle {
namespace {

constexpr std::uint64_t campaign_seed = 1;

GrazingCount judged_pairs(const GrazingAnswers& of, std::uint64_t first, std::uint64_t count) {
  GrazingCount sum;
  for (std::uint64_t i = first; i < first + count; ++i)
    sum.merge(check_grazing_pair(of, campaign_seed, i));
  return sum;
}

/// How many checks the long campaign is to make: LIGHTCUTS_GRAZING_CHECKS, by default 10^6.
double wanted_checks() {
  const char* wanted = std::getenv("LIGHTCUTS_GRAZING_CHECKS");
  return wanted == nullptr ? 1e6 : std::atof(wanted);
}

// Every lobe and kind, mirrored to the last bits, at every height that floats have.
TEST(GrazingPairs, HoldForTheLibrary) {
  const double wanted = wanted_checks();
  const auto start = Clock::now();
  GrazingCount sum;
  double next_report = 60;
  const auto said = [&] {
    return fmt::format("{} checks at {} pairs, {} numbers decided in 700 bits, {} violations; "
                       "transfer errs by {:.3f} of what is stated; {:.0f} s",
                       sum.all_checks(), sum.pairs, sum.exact, sum.violations, sum.worst_transfer,
                       seconds_since(start));
  };
  while (double(sum.all_checks()) < wanted) {
    sum.merge(check_grazing_pair(GrazingAnswers(), campaign_seed, sum.pairs));
    if (seconds_since(start) < next_report) continue;
    fmt::print("{}\n", said());
    std::fflush(stdout);
    next_report += 60;
  }
  fmt::print("{}\n", said());
  EXPECT_EQ(sum.violations, 0U) << sum.first_violation;
  EXPECT_LE(sum.worst_transfer, 1);
  EXPECT_GT(sum.worst_transfer, 0);
  for (const std::uint64_t checks : sum.checks) EXPECT_GT(double(checks), 0.1 * double(wanted));
}

TEST(GrazingPairs, GiveTheSameNumbersEachTime) {
  const GrazingCount once = judged_pairs(GrazingAnswers(), 0, 2);
  const GrazingCount again = judged_pairs(GrazingAnswers(), 0, 2);
  EXPECT_EQ(once.checks, again.checks);
  EXPECT_EQ(once.exact, again.exact);
  EXPECT_EQ(once.worst_transfer, again.worst_transfer);
}

/// The tangent of the half vector by way of l + v in double, whose digits cancel, as it was once.
struct Cancelling : GrazingAnswers {
  [[nodiscard]] glm::dvec3 transfer(const ShadingPoint& point, const Light& light,
                                    float min_distance) const override {
    const glm::dvec3 right = GrazingAnswers::transfer(point, light, min_distance);
    const auto* ward = std::get_if<Ward>(&point.material().lobe);
    const Sight sight(point, light.kind, light.position);
    if (ward == nullptr || right == glm::dvec3(0)) return right;
    const glm::dvec3 n = glm::normalize(glm::dvec3(point.normal()));
    const glm::dvec3 sum =
        sight.q() / sight.distance() + glm::normalize(glm::dvec3(point.to_viewer()));
    const double up = glm::dot(n, sum);
    const double tangent2 = glm::dot(sum, sum) / (up * up) - 1;
    const double a2 = double(ward->alpha) * ward->alpha;
    return right * std::exp((sight.half_tangent2() - tangent2) / a2);
  }
};

struct TransferOff : GrazingAnswers {
  [[nodiscard]] glm::dvec3 transfer(const ShadingPoint& point, const Light& light,
                                    float min_distance) const override {
    return GrazingAnswers::transfer(point, light, min_distance) * (1 + 0x1p-26);
  }
};
struct BoundOff : GrazingAnswers {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return GrazingAnswers::bound(tree, node, point) * (1 - 0x1p-20F);
  }
};
struct BlockBoundOff : GrazingAnswers {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingBlock& block) const override {
    return GrazingAnswers::bound(tree, node, block) * 0x1p-10F;
  }
};
struct LowerBoundOff : GrazingAnswers {
  [[nodiscard]] glm::vec3 lower_bound(const LightTree& tree, std::uint32_t node,
                                      const ShadingPoint& point) const override {
    return GrazingAnswers::lower_bound(tree, node, point) * (1 + 0x1p-20F);
  }
};
struct CertificateOff : GrazingAnswers {
  [[nodiscard]] Cut cut(CutSelector& select, const ShadingPoint& point) const override {
    Cut cut = GrazingAnswers::cut(select, point);
    cut.certified_error *= 0x1p-10F;
    return cut;
  }
};

TEST(GrazingPairs, ConvictWhatIsBroken) {
  EXPECT_GT(judged_pairs(Cancelling(), 0, 60).violations, 0U);
  EXPECT_GT(judged_pairs(TransferOff(), 0, 2).violations, 0U);
  EXPECT_GT(judged_pairs(BoundOff(), 0, 4).violations, 0U);
  EXPECT_GT(judged_pairs(BlockBoundOff(), 0, 20).violations, 0U);
  EXPECT_GT(judged_pairs(LowerBoundOff(), 0, 20).violations, 0U);
  EXPECT_GT(judged_pairs(CertificateOff(), 0, 20).violations, 0U);
}

TEST(GrazingPairs, SayWhichOneFails) {
  const GrazingCount count = judged_pairs(TransferOff(), 3, 1);
  EXPECT_EQ(count.first_violation.find("seed 1, pair 3: check 0 of "), 0U) << count.first_violation;
}

} // namespace
} // namespace lightcuts::oracle
