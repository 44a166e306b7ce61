// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {
namespace {

bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
  for (int c = 0; c < 3; ++c)
    if (!(a[c] == b[c]) && !(std::isnan(a[c]) && std::isnan(b[c]))) return false;
  return true;
}

// What differs between two trees that should be the same; nothing where they agree.

std::string differing_cluster(const PointAnswers& of, SubjectTree& other) {
  const Judged& judged = of.judged;
  const ShadingPoint& point = of.at.point;
  if (!judged.has(Part::bounds)) return {};
  // All at once: single answers may be kept from the last time.
  std::vector<glm::vec3> bounds(of.topology().size()), again(bounds.size());
  judged.tree.bounds(point, bounds);
  other.bounds(point, again);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    if (!same_bits(bounds[i], again[i])) return fmt::format("bound of node {}", i);
    if (judged.has(Part::estimates) &&
        !same_bits(judged.tree.estimate(i, point, bounds[i]), other.estimate(i, point, bounds[i])))
      return fmt::format("estimate of node {}", i);
  }
  return {};
}

std::string differing_cut(const PointAnswers& of, SubjectTree& other, const CutConfig& config) {
  if (!of.judged.has(Part::cuts)) return {};
  const Cut cut = of.select(config);
  const std::vector<CutCluster> clusters(cut.clusters.begin(), cut.clusters.end());
  const Cut again = PointAnswers({other, of.judged.parts}, of.at).select(config);
  const bool same =
      same_bits(cut.radiance, again.radiance) &&
      same_bits(cut.certified_error, again.certified_error) &&
      std::equal(clusters.begin(), clusters.end(), again.clusters.begin(), again.clusters.end(),
                 [](const auto& a, const auto& b) { return a.node == b.node; });
  return same ? "" : "cut";
}

std::string differing_draw(const PointAnswers& of, SubjectTree& other) {
  if (!of.judged.has(Part::sampling)) return {};
  constexpr std::array u{0.0, 0.3, 0.5, 0.7, 1 - 0x1p-53};
  std::array<DrawnLight, u.size()> a, b;
  of.judged.tree.samples(0, of.at.point, u, a);
  other.samples(0, of.at.point, u, b);
  for (std::size_t i = 0; i < u.size(); ++i)
    if (a[i].light != b[i].light || a[i].probability != b[i].probability)
      return fmt::format("light drawn by u = {}", u[i]);
  return {};
}

void check_agreement(const PointAnswers& of, const CutConfig& config, const Recorder& record) {
  const std::unique_ptr<SubjectTree> elsewhere = of.judged.tree.for_another_thread();
  std::string difference;
  const auto compare = [&](SubjectTree& tree, const char* who) {
    for (const auto& what :
         {differing_cluster(of, tree), differing_cut(of, tree, config), differing_draw(of, tree)})
      if (difference.empty() && !what.empty())
        difference = fmt::format("{}: another {} from {}", of.at.text(), what, who);
  };
  compare(of.judged.tree, "the same tree, asked again");
  compare(*elsewhere, "another thread's tree");
  record(difference.empty(), [&] { return difference; });
}

} // namespace

const PropertyInfo property::threads_agree{
    .name = "threads-agree",
    .statement = "Asked again, and by another thread, it answers the same bits.",
    .formula = "bounds, estimates, radiance, certified error, draws",
    .of_point = check_agreement,
};

} // namespace lightcuts::oracle
