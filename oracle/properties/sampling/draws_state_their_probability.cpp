// SPDX-License-Identifier: MIT
#include <array>

#include <fmt/format.h>

#include <oracle/properties/sampling/cluster_odds.h>

namespace lightcuts::oracle {
namespace {

void check_drawn(const ClusterOdds& of, double u, const DrawnLight& drawn, const Recorder& record) {
  if (drawn.probability == 0) {
    // That is what is left of 1.
    record(of.none() > 0x1p-40, [&] {
      return fmt::format("{}: u = {} draws nothing of node {}, though its probabilities sum to 1",
                         of.point.at.text(), u, of.node);
    });
    return;
  }
  const double stated = of.stated(drawn.light);
  record(stated == drawn.probability, [&] {
    return fmt::format("{}: u = {} draws light {} of node {} with probability {:.17g}, which is "
                       "{:.17g}",
                       of.point.at.text(), u, drawn.light, of.node, drawn.probability, stated);
  });
}

void check(const ClusterOdds& of, const Recorder& record) {
  std::array<double, 8> random;
  for (std::size_t i = 0; i < random.size(); ++i)
    random[i] = (double(i) + 0.5) / double(random.size());
  std::array<DrawnLight, random.size()> drawn;
  of.point.judged.tree.samples(of.node, of.point.at.point, random, drawn);
  for (std::size_t i = 0; i < random.size(); ++i) check_drawn(of, random[i], drawn[i], record);
}

} // namespace

const PropertyInfo property::draws_state_their_probability{
    .name = "draws-state-their-probability",
    .statement = "What is drawn comes with the probability of drawing it.",
    .formula = "probability of sample() = probability() of the same light",
    .needs = only(Part::sampling),
    .of_odds = check,
};

} // namespace lightcuts::oracle
