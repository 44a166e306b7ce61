// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {
namespace {

constexpr std::array numbers{0.1, 0.6, 0.9};
constexpr std::array<std::uint64_t, 3> queries{0, 1, 0x9e3779b97f4a7c15};
constexpr std::uint32_t most_nodes = 8;

/// What is drawn at a point: single lights of the first nodes, and random cuts.
struct Drawn {
  struct Random {
    glm::vec3 radiance, certified_error;
    std::vector<std::uint32_t> nodes;
    std::vector<glm::dvec3> estimates;
    bool operator==(const Random&) const = default;
  };
  std::vector<DrawnLight> lights; ///< by each of the numbers, of each node
  std::vector<Random> cuts;       ///< by each of the queries
};

Drawn drawn_by(SubjectTree& tree, const PointAnswers& of, const CutConfig& config) {
  Drawn drawn;
  const std::uint32_t nodes = std::min(of.topology().size(), most_nodes);
  for (std::uint32_t node = 0; node < nodes; ++node) {
    std::array<DrawnLight, numbers.size()> some;
    tree.samples(node, of.at.point, numbers, some);
    drawn.lights.insert(drawn.lights.end(), some.begin(), some.end());
  }
  if (!of.judged.has(Part::random_cuts)) return drawn;
  tree.draws(
      of.at.point, config, queries, [&](std::uint32_t light) { return of.at.sees(light); },
      [&](const Cut& cut) {
        Drawn::Random& one = drawn.cuts.emplace_back();
        one.radiance = cut.radiance;
        one.certified_error = cut.certified_error;
        for (const CutCluster& c : cut.clusters) {
          one.nodes.push_back(c.node);
          one.estimates.push_back(c.estimate);
        }
      });
  return drawn;
}

/// What differs; nothing where they are the same.
std::string difference_of(const Drawn& a, const Drawn& b) {
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    const DrawnLight &x = a.lights[i], &y = b.lights[i];
    if (x.light != y.light || x.probability != y.probability)
      return fmt::format("u = {} draws light {} of node {} with probability {:.17g}, and light {} "
                         "with {:.17g}",
                         numbers[i % numbers.size()], x.light, i / numbers.size(), x.probability,
                         y.light, y.probability);
  }
  for (std::size_t i = 0; i < a.cuts.size(); ++i)
    if (!(a.cuts[i] == b.cuts[i]))
      return fmt::format("query {} draws radiance {}, and {}", queries[i],
                         digits_of(a.cuts[i].radiance), digits_of(b.cuts[i].radiance));
  return {};
}

void check_again(const PointAnswers& of, const CutConfig& config, const Recorder& record) {
  const Drawn first = drawn_by(of.judged.tree, of, config);
  const std::unique_ptr<SubjectTree> elsewhere = of.judged.tree.for_another_thread();
  const std::string again = difference_of(first, drawn_by(of.judged.tree, of, config));
  const std::string other = difference_of(first, drawn_by(*elsewhere, of, config));
  record(again.empty() && other.empty(), [&] {
    return fmt::format("{}: {} {}", of.at.text(), again.empty() ? other : again,
                       again.empty() ? "by another thread" : "when asked again");
  });
}

} // namespace

const PropertyInfo property::draws_are_repeatable{
    .name = "draws-are-repeatable",
    .statement = "The same question by the same random numbers draws the same bits.",
    .formula = "lights and probabilities of sample(), clusters and estimates of random cuts",
    .needs = only(Part::sampling),
    .of_point = check_again,
};

} // namespace lightcuts::oracle
