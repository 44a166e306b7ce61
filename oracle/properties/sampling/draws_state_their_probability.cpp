// SPDX-License-Identifier: MIT
#include <algorithm>
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

/// The two neighbouring numbers that draw different lights, once it is narrow enough.
struct Border {
  double low, high;
  std::uint32_t first; ///< what the low one draws, and the high one does not

  [[nodiscard]] bool is_found() const { return !(std::nextafter(low, high) < high); }
};

/// Draws, and checks what is drawn; many at once, as each question to a plug-in takes its time.
class Drawing {
public:
  Drawing(const ClusterOdds& of, const Recorder& record) : of_(of), record_(record) {}

  void by(std::span<const double> middle, std::span<const double> border) const {
    std::vector<double> random(middle.begin(), middle.end());
    random.insert(random.end(), border.begin(), border.end());
    const std::vector<DrawnLight> all = drawn(random);
    for (std::size_t i = 0; i < all.size(); ++i)
      check_drawn(of_, random[i], i < middle.size() ? Place::middle : Place::border, all[i],
                  record_);
  }

  /// Ever nearer to 0 and 1: what draws nothing there, however often it is asked, does so more
  /// often than the probabilities leave room for.
  void near_ends() const {
    constexpr std::array exponents{10, 16, 22, 28, 34};
    constexpr std::array shares{0.97, 0.71, 0.43, 0.29};
    std::vector<double> random;
    for (const bool at_one : {false, true})
      for (const int exponent : exponents)
        for (const double share : shares) {
          const double off = std::ldexp(share, -exponent);
          random.push_back(at_one ? 1 - off : off);
        }
    const std::vector<DrawnLight> all = drawn(random);
    const double rounding = 0x1p-48 * double(of_.lights.size());
    for (std::size_t i = 0; i < all.size(); i += shares.size()) {
      const auto nothing = std::count_if(
          all.begin() + std::ptrdiff_t(i), all.begin() + std::ptrdiff_t(i + shares.size()),
          [](const DrawnLight& one) { return one.probability == 0; });
      const int exponent = exponents[i / shares.size() % exponents.size()];
      record_(nothing < std::ptrdiff_t(shares.size()) ||
                  of_.none() + rounding > std::ldexp(1.0, -exponent - 8),
              [&] {
                return fmt::format("{}: all numbers around u = {} draw nothing of node {}, though "
                                   "its probabilities sum to 1 but for {}",
                                   of_.point.at.text(), random[i], of_.node, of_.none());
              });
    }
  }

  /// A border in each interval whose ends draw different lights.
  void at_borders(std::span<const double> ends) const {
    std::vector<Border> open;
    const std::vector<std::uint32_t> at_ends = lights(ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (at_ends[i] != at_ends[i + 1]) open.push_back({ends[i], ends[i + 1], at_ends[i]});
    std::vector<double> found;
    while (!open.empty()) {
      narrow(open);
      std::erase_if(open, [&](const Border& b) {
        if (b.is_found()) found.insert(found.end(), {b.low, b.high});
        return b.is_found();
      });
    }
    by({}, found);
  }

private:
  static constexpr int parts = 8; ///< even: halves are among them, so that all become narrower

  [[nodiscard]] std::vector<DrawnLight> drawn(std::span<const double> random) const {
    std::vector<DrawnLight> all(random.size());
    if (!all.empty()) of_.point.judged.tree.samples(of_.node, of_.point.at.point, random, all);
    return all;
  }

  [[nodiscard]] std::vector<std::uint32_t> lights(std::span<const double> random) const {
    std::vector<std::uint32_t> result;
    for (const DrawnLight& one : drawn(random))
      result.push_back(one.probability == 0 ? std::uint32_t(-1) : one.light);
    return result;
  }

  /// Each to the first of its parts whose end draws another light.
  void narrow(std::vector<Border>& open) const {
    std::vector<double> between;
    for (const Border& b : open)
      for (int k = 1; k < parts; ++k) between.push_back(b.low + (b.high - b.low) * k / parts);
    const std::vector<std::uint32_t> light = lights(between);
    std::size_t next = 0;
    for (Border& b : open) {
      const std::size_t end = next + parts - 1;
      std::size_t k = next;
      while (k < end && light[k] == b.first) ++k;
      if (k > next) b.low = between[k - 1];
      if (k < end) b.high = between[k];
      next = end;
    }
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
  drawing.by(random, std::array{0.0, largest});
  if (of.node == 0) drawing.near_ends();
  // Each border takes 100 draws or more.
  constexpr std::size_t few = 8;
  if (of.node == 0 && of.lights.size() <= few)
    drawing.at_borders(std::array{0.0, 0.25, 0.5, 0.75, largest});
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
