// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <oracle/explain/explain_parts.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/judge.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

// Larger cuts are of counterexamples that could not be shrunk.
constexpr std::size_t most_clusters = 60;

/// A cut of its own, that outlives the next one.
struct KeptCut {
  CutConfig config;
  std::vector<CutCluster> clusters;
  Cut cut;

  KeptCut(const PointAnswers& of, const ChosenCut& chosen)
      : config(chosen.config), cut(of.select(config, chosen.all_seen)) {
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
  Refinement(const PointAnswers& of, const KeptCut& cut)
      : of_(of), cut_(cut), place_(of.topology().size(), none),
        leads_(of.topology().size(), false) {
    std::string strays;
    for (std::size_t i = 0; i < cut.clusters.size(); ++i)
      if (cut.clusters[i].node < place_.size() && place_[cut.clusters[i].node] == none)
        place_[cut.clusters[i].node] = i;
      else
        strays += fmt::format("  {:<20}once more, or no node at all\n", cut.clusters[i].node);
    const auto nodes = of.topology().parents_first();
    for (auto i = nodes.rbegin(); i != nodes.rend(); ++i)
      for (const std::uint32_t child : of.topology().children(*i))
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
      const auto children = of_.topology().children(node);
      for (auto child = children.rbegin(); leads_[node] && child != children.rend(); ++child)
        open.emplace_back(*child, depth + 1);
    }
  }

  [[nodiscard]] std::string line(std::uint32_t node, std::size_t depth) const {
    const std::string name =
        std::string(std::min<std::size_t>(depth, 12), ' ') + fmt::format("{}", node);
    const std::string start = fmt::format("  {:<20}{:>8}", name, of_.topology().light_count(node));
    if (place_[node] != none) {
      const CutCluster& c = cut_.clusters[place_[node]];
      return start + numbers(c.bound, c.estimate) + "in the cut" + (c.visible ? "" : ", hidden") +
             (leads_[node] ? ", and others below" : "") + "\n";
    }
    const char* what = leads_[node] ? "refined" : "MISSING";
    if (!of_.judged.has(Part::bounds) || !of_.judged.has(Part::estimates))
      return start + fmt::format("{:48}{}\n", "", what);
    return start + numbers(of_.bounds()[node], of_.estimates()[node]) + what + "\n";
  }

  [[nodiscard]] std::string numbers(const glm::vec3& bound, const glm::dvec3& estimate) const {
    return fmt::format("{:>16.8g}{:>16.8g}{:>14.6g}  ", std::max({bound.x, bound.y, bound.z}),
                       std::max({estimate.x, estimate.y, estimate.z}), share(bound, cut_));
  }

  const PointAnswers& of_;
  const KeptCut& cut_;
  std::vector<std::size_t> place_; ///< per node, in the cut; or none
  std::vector<bool> leads_;        ///< per node, whether clusters of the cut are below
  std::string text_;
};

const char* end_text(CutEnd end) {
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
         row_of("truth, 700 bits", [&](int c) { return text_of(truth[std::size_t(c)], 20); }) +
         row_of("|radiance - truth|", [&](int c) { return text_of(error[std::size_t(c)], 9); }) +
         number_row("certified error", cut.cut.certified_error);
}

std::string cut_text(const PointAnswers& of, const KeptCut& cut) {
  return fmt::format("cut: {}\nrefinement, children below their parents; of bounds and estimates "
                     "the largest channel;\n\"of allowed\" = bound / max(threshold * total, black "
                     "level), in the worst channel\n",
                     text_of(cut.config)) +
         Refinement(of, cut).text() +
         fmt::format("it ended with {} cluster{}, as it says: {}\n\n", cut.clusters.size(),
                     cut.clusters.size() == 1 ? "" : "s", end_text(cut.cut.end)) +
         totals_text(cut, of.at);
}

std::string parting(std::string where) { return "\n" + wrapped("they part here: " + where); }

std::string one_cut(const PointAnswers& of, Property property, const CutConfig& configured) {
  for (const CutConfig& config : cuts_of(configured, of.at.lights().size())) {
    const KeptCut cut(of, {config});
    Tally tally;
    Judge(of.judged.parts, 0, tally, property).cut(of, config, cut.cut);
    if (tally[property].violations == 0) continue;
    std::string where;
    if (const auto part = info(property).parting) where = part(CutAnswer(of, config, cut.cut));
    return cut_text(of, cut) + parting(where.empty() ? tally[property].first_violation : where);
  }
  return {};
}

std::string two_cuts(const PointAnswers& of, Property property, const CutConfig& config) {
  Tally tally;
  Judge(of.judged.parts, 0, tally, property).point(of, config);
  if (tally[property].violations == 0) return {};
  const TwoCuts cuts = info(property).two_cuts(of, config);
  return cut_text(of, {of, cuts.one}) + "\n" + cut_text(of, {of, cuts.other}) +
         parting(tally[property].first_violation);
}

} // namespace

std::string explain_cut(const PointAnswers& of, Property property, const CutConfig& config) {
  if (!of.judged.has(Part::cuts)) return {};
  if (info(property).of_cut != nullptr) return one_cut(of, property, config);
  return info(property).two_cuts != nullptr ? two_cuts(of, property, config) : std::string();
}

} // namespace lightcuts::oracle
