// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/sampling/cluster_odds.h>

namespace lightcuts::oracle {
namespace {

/// Random numbers in the middle of things, or where one light follows another: a draw of nothing
/// may be as rare as it wants to be, and only there it shows.
enum class Place { middle, border };

void check_drawn(const ClusterOdds& of, double u, Place place_of_u, const DrawnLight& drawn,
                 const Recorder& record) {
  if (drawn.probability == 0) {
    // That is what is left of 1.
    record(of.none() > 0x1p-40 || place_of_u == Place::border, [&] {
      return fmt::format("{}: u = {} draws nothing of node {}, though its probabilities sum to 1",
                         of.point.at.text(), u, of.node);
    });
    return;
  }
  const std::size_t place = of.place_of(drawn.light);
  const double stated = place < of.p.size() ? of.p[place] : 0;
  // A product of one factor for each level, which rounds by 2^-53 as a factor (1 - p may stand for
  // it: 2^-52) and by 2^-53 when it is multiplied, in sample() and in probability().
  const int levels = place < of.p.size() ? of.levels[place] : 0;
  const double allowed = levels * (0x1p-50 * stated + 0x1p-1074);
  record(std::abs(stated - drawn.probability) <= allowed, [&] {
    return fmt::format("{}: u = {} draws light {} of node {} with probability {:.17g}, which is "
                       "{:.17g}",
                       of.point.at.text(), u, drawn.light, of.node, drawn.probability, stated);
  });
}

/// Draws, and checks what is drawn.
class Drawing {
public:
  Drawing(const ClusterOdds& of, const Recorder& record) : of_(of), record_(record) {}

  void by(std::span<const double> random, Place place) const {
    std::vector<DrawnLight> drawn(random.size());
    of_.point.judged.tree.samples(of_.node, of_.point.at.point, random, drawn);
    for (std::size_t i = 0; i < random.size(); ++i)
      check_drawn(of_, random[i], place, drawn[i], record_);
  }

  /// A border between lights, if another one is drawn by `high` than by `low`: the two neighbouring
  /// numbers that draw different ones.
  void at_border(double low, double high) const {
    const std::uint32_t first = light(low);
    if (light(high) == first) return;
    while (std::nextafter(low, high) < high) {
      const double middle = low + 0.5 * (high - low);
      (light(middle) == first ? low : high) = middle;
    }
    by(std::array{low, high}, Place::border);
  }

private:
  [[nodiscard]] std::uint32_t light(double u) const {
    const DrawnLight drawn = of_.point.judged.tree.sample(of_.node, of_.point.at.point, u);
    return drawn.probability == 0 ? std::uint32_t(-1) : drawn.light;
  }

  const ClusterOdds& of_;
  const Recorder& record_;
};

constexpr double largest = 1 - 0x1p-53; // below 1

void check_stated_probability(const ClusterOdds& of, const Recorder& record) {
  std::array<double, 8> random;
  for (std::size_t i = 0; i < random.size(); ++i)
    random[i] = (double(i) + 0.5) / double(random.size());
  const Drawing drawing(of, record);
  drawing.by(random, Place::middle);
  drawing.by(std::array{0.0, largest}, Place::border);
  // Each takes 50 draws or more.
  constexpr std::size_t few = 8;
  if (of.node != 0 || of.lights.size() > few) return;
  for (int i = 0; i < 4; ++i) drawing.at_border(i / 4.0, i == 3 ? largest : (i + 1) / 4.0);
}

} // namespace

const PropertyInfo property::draws_state_their_probability{
    .name = "draws-state-their-probability",
    .statement = "What is drawn comes with the probability of drawing it.",
    .formula = "probability of sample() = probability() of the same light, but for 2^-50 of it for "
               "each level of the tree",
    .needs = only(Part::sampling),
    .of_odds = check_stated_probability,
};

} // namespace lightcuts::oracle
