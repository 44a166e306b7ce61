// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <oracle/campaign/check_case.h>
#include <oracle/properties/case_properties.h>

#include <oracle/explain/explain_parts.h>

namespace lightcuts::oracle {
namespace {

// Larger cuts are of counterexamples that could not be shrunk.
constexpr std::size_t most_clusters = 60;

/// A cut of its own, that outlives the next one.
struct KeptCut {
  CutConfig config;
  std::vector<CutCluster> clusters;
  Cut cut;

  KeptCut(const Judged& judged, const CutConfig& with, const PointCase& at, bool all_seen = false)
      : config(with) {
    cut = judged.tree.select(at.point, config, [&](std::uint32_t light) {
      return all_seen || (light < at.visible.size() && at.visible[light] != 0);
    });
    clusters.assign(cut.clusters.begin(), cut.clusters.end());
    cut.clusters = clusters;
  }
  KeptCut(const KeptCut&) = delete;
  KeptCut& operator=(const KeptCut&) = delete;

  [[nodiscard]] glm::dvec3 total() const {
    glm::dvec3 sum(0);
    for (const CutCluster& c : clusters) sum += c.estimate;
    return sum;
  }
};

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The largest bound / max(threshold total, black level) of the channels.
double share(const glm::vec3& bound, const KeptCut& cut) {
  const glm::dvec3 total = cut.total();
  double worst = 0;
  for (int c = 0; c < 3; ++c)
    worst = std::max(worst, ratio_of(bound[c], std::max<double>(cut.config.threshold * total[c],
                                                                cut.config.black_level)));
  return worst == std::numeric_limits<double>::max() ? infinite : worst;
}

/// A line per cluster, from the root down to the cut.
class Refinement {
public:
  Refinement(const Judged& judged, const KeptCut& cut, const PointCase& at)
      : judged_(judged), cut_(cut), at_(at), place_(at.topology().size(), none),
        leads_(at.topology().size(), false) {
    std::string strays;
    for (std::size_t i = 0; i < cut.clusters.size(); ++i)
      if (cut.clusters[i].node < place_.size() && place_[cut.clusters[i].node] == none)
        place_[cut.clusters[i].node] = i;
      else
        strays += fmt::format("  {:<20}once more, or no node at all\n", cut.clusters[i].node);
    const auto nodes = at.topology().parents_first();
    for (auto i = nodes.rbegin(); i != nodes.rend(); ++i)
      for (const std::uint32_t child : at.topology().children(*i))
        leads_[*i] = leads_[*i] || leads_[child] || place_[child] != none;
    text_ = fmt::format("  {:<20}{:>8}{:>16}{:>16}{:>14}\n", "node", "lights", "bound", "estimate",
                        "of allowed");
    descend();
    text_ += strays;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  void descend() {
    std::vector<std::pair<std::uint32_t, std::size_t>> open{{0, 0}}; // node, depth
    for (std::size_t lines = 0; !open.empty(); ++lines) {
      if (lines == most_clusters) {
        text_ += "  ...\n";
        return;
      }
      const auto [node, depth] = open.back();
      open.pop_back();
      text_ += line(node, depth);
      const auto children = at_.topology().children(node);
      for (auto child = children.rbegin(); leads_[node] && child != children.rend(); ++child)
        open.emplace_back(*child, depth + 1);
    }
  }

  [[nodiscard]] std::string line(std::uint32_t node, std::size_t depth) const {
    const std::string name =
        std::string(std::min<std::size_t>(depth, 12), ' ') + fmt::format("{}", node);
    const std::string start = fmt::format("  {:<20}{:>8}", name, at_.topology().light_count(node));
    if (place_[node] != none) {
      const CutCluster& c = cut_.clusters[place_[node]];
      return start + numbers(c.bound, c.estimate) + "in the cut" + (c.visible ? "" : ", hidden") +
             (leads_[node] ? ", and others below" : "") + "\n";
    }
    const char* what = leads_[node] ? "refined" : "MISSING";
    if (!judged_.has(Part::bounds) || !judged_.has(Part::estimates))
      return start + fmt::format("{:48}{}\n", "", what);
    const glm::vec3 bound = judged_.tree.bound(node, at_.point);
    return start + numbers(bound, seen_estimate(judged_, node, at_, bound)) + what + "\n";
  }

  [[nodiscard]] std::string numbers(const glm::vec3& bound, const glm::dvec3& estimate) const {
    return fmt::format("{:>16.8g}{:>16.8g}{:>14.6g}  ", std::max({bound.x, bound.y, bound.z}),
                       std::max({estimate.x, estimate.y, estimate.z}), share(bound, cut_));
  }

  const Judged& judged_;
  const KeptCut& cut_;
  const PointCase& at_;
  std::vector<std::size_t> place_; ///< per node, in the cut; or none
  std::vector<bool> leads_;        ///< per node, whether clusters of the cut are below
  std::string text_;
};

const char* text_of(CutEnd end) {
  switch (end) {
  case CutEnd::converged:
    return "every bound obeys the threshold";
  case CutEnd::black_level:
    return "every bound obeys the threshold or the black level";
  case CutEnd::max_size:
    return "the largest size was reached";
  }
  return "for an unknown reason";
}

std::string totals_text(const KeptCut& cut, const PointCase& at) {
  std::array<Exact, 3> truth, error;
  for (int c = 0; c < 3; ++c) {
    const auto k = std::size_t(c);
    truth[k] = at.truth.exact_seen(0, c);
    const float radiance = cut.cut.radiance[c];
    error[k] = std::isfinite(radiance) ? Exact(abs(Exact(radiance) - truth[k])) : Exact(0);
  }
  return channel_head() + number_row("sum of estimates", cut.total()) +
         number_row("radiance", cut.cut.radiance) +
         row_of("truth, 700 bits",
                [&](int c) { return oracle::text_of(truth[std::size_t(c)], 20); }) +
         row_of("|radiance - truth|",
                [&](int c) { return oracle::text_of(error[std::size_t(c)], 9); }) +
         number_row("certified error", cut.cut.certified_error);
}

std::string cut_text(const Judged& judged, const KeptCut& cut, const PointCase& at) {
  return fmt::format("cut: {}\nrefinement, children below their parents; of bounds and estimates "
                     "the largest channel;\n\"of allowed\" = bound / max(threshold * total, black "
                     "level), in the worst channel\n",
                     oracle::text_of(cut.config)) +
         Refinement(judged, cut, at).text() +
         fmt::format("it ended with {} cluster{}, as it says: {}\n\n", cut.clusters.size(),
                     cut.clusters.size() == 1 ? "" : "s", text_of(cut.cut.end)) +
         totals_text(cut, at);
}

/// The cluster whose bound exceeds what is allowed the most.
std::string worst_cluster(const Judged& judged, const KeptCut& cut, const PointCase& at) {
  double worst = 0;
  std::uint32_t node = 0;
  for (const CutCluster& c : cut.clusters) {
    if (c.node >= at.topology().size() || at.topology().light_count(c.node) == 1) continue;
    const double r = share(judged.tree.bound(c.node, at.point), cut);
    if (r <= worst) continue;
    worst = r;
    node = c.node;
  }
  return wrapped(fmt::format("they part here: the bound of node {} is {:.6g} times what is "
                             "allowed, and yet refinement ended with {} clusters of at most {}",
                             node, worst, cut.clusters.size(), cut.config.max_size));
}

std::string parting(const Judged& judged, Property property, const KeptCut& cut,
                    const PointCase& at, const std::string& message) {
  const bool too_large = cut.clusters.size() > cut.config.max_size;
  if (property == Property::cut_obeys_threshold && judged.has(Part::bounds) && !too_large)
    return "\n" + worst_cluster(judged, cut, at);
  return "\n" + wrapped("they part here: " + message);
}

std::string one_cut(const Judged& judged, Property property, const Case& on, const PointCase& at) {
  for (const CutConfig& config : cuts_of(on)) {
    const KeptCut cut(judged, config, at);
    Tally tally;
    check_cut(judged, config, cut.cut, at, tally);
    if (tally[property].violations > 0)
      return cut_text(judged, cut, at) +
             parting(judged, property, cut, at, tally[property].first_violation);
  }
  return {};
}

/// The two cuts of check_nesting() or check_darkening().
std::string two_cuts(const Judged& judged, const KeptCut& one, const KeptCut& other,
                     const PointCase& at, const std::string& message) {
  return cut_text(judged, one, at) + "\n" + cut_text(judged, other, at) + "\n" +
         wrapped("they part here: " + message);
}

} // namespace

std::string explain_cut(const Judged& judged, Property property, const Case& on,
                        const PointCase& at) {
  if (!judged.has(Part::cuts)) return {};
  if (std::string text = one_cut(judged, property, on, at); !text.empty()) return text;
  Tally tally;
  check_nesting(judged, on.cut, at, tally);
  check_darkening(judged, at, tally);
  if (tally[property].violations == 0) return {};
  const std::string& message = tally[property].first_violation;
  if (property == Property::tighter_threshold_refines) {
    CutConfig coarse = on.cut;
    coarse.black_level = 0;
    CutConfig fine = coarse;
    fine.threshold /= 4;
    return two_cuts(judged, {judged, coarse, at}, {judged, fine, at}, at, message);
  }
  const CutConfig exact{0, std::uint32_t(at.lights().size()), 0};
  return two_cuts(judged, {judged, exact, at, true}, {judged, exact, at}, at, message);
}

} // namespace lightcuts::oracle
