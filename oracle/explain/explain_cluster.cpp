// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/explain/explain_parts.h>
#include <oracle/explain/failing_place.h>
#include <oracle/properties/both_sides.h>
#include <oracle/properties/text_rows.h>
#include <oracle/truth/radiometry.h>

namespace lightcuts::oracle {
namespace {

// Larger clusters are of counterexamples that could not be shrunk.
constexpr std::size_t most_listed_lights = 12;

using ExactVector = radiometry::Vector<Exact>;

std::string vector_text(const ExactVector& v) {
  return fmt::format("({}, {}, {})", text_of(v[0], 9), text_of(v[1], 9), text_of(v[2], 9));
}

// ---- the lights

/// f of the material for light along `way`.
ExactVector brdf(const ShadingPoint& point, const radiometry::Way<Exact>& way) {
  ExactVector f = std::visit([&](const auto& lobe) { return radiometry::lobe<Exact>(lobe, way); },
                             point.material().lobe);
  for (int c = 0; c < 3; ++c)
    f[std::size_t(c)] += Exact(point.material().diffuse[c]) / radiometry::pi<Exact>();
  return f;
}

/// 1/max(|q|^2, least^2); 1 for a directional light.
Exact falloff(const Light& light, const radiometry::Way<Exact>& way, float min_distance) {
  if (is_at_infinity(light.kind)) return 1;
  const Exact least2 = Exact(min_distance) * Exact(min_distance);
  return 1 / (way.distance2 < least2 ? least2 : way.distance2);
}

std::string exact_line(const std::string& name, const Exact& value, const char* note = "") {
  return line("  " + name, text_of(value), note);
}

/// Where it shines.
std::string axis_text(const Light& light) {
  std::string text;
  if (has_axis(light.kind)) text += line("  axis", text_of(light.axis));
  if (light.kind == LightKind::spot)
    text += line("  cosines of rims",
                 fmt::format("{:.9g} and {:.9g}", light.cos_inner, light.cos_outer));
  if (light.kind == LightKind::profile)
    text += line("  horizontal angle 0", text_of(light.plane)) +
            line("  vertical angles, half-planes",
                 fmt::format("{} and {}", light.profile.table().rows(),
                             light.profile.table().planes()));
  return text;
}

std::string light_text(const PointCase& at, std::uint32_t index) {
  const Light& light = at.lights()[index];
  const float min_distance = at.lights().min_distance();
  const radiometry::Way<Exact> way(at.point, light);
  std::string text = fmt::format(
      "  light {}{}: {} {} {}\n", index, at.visible[index] == 0 ? " (hidden)" : "",
      name_of(light.kind), is_at_infinity(light.kind) ? "towards" : "at", text_of(light.position));
  text += line("  intensity", text_of(light.intensity)) + axis_text(light);
  text += line("  q", vector_text(way.q));
  text += exact_line("|q|^2", way.distance2) + exact_line("|q|", way.distance);
  if (way.n_dot_l <= 0)
    return text + exact_line("n.l", way.n_dot_l, "not above the horizon: contributes 0");
  text += exact_line("n.l", way.n_dot_l);
  text += exact_line("falloff", falloff(light, way, min_distance),
                     is_at_infinity(light.kind) ? "" : "1/max(|q|^2, least distance^2)");
  text += exact_line("emission", radiometry::emission<Exact>(light, at.point, way.distance));
  const ExactVector f = brdf(at.point, way);
  text += row_of("  BRDF", [&](int c) { return text_of(f[std::size_t(c)]); });
  std::array<Exact, 3> sent;
  for (int c = 0; c < 3; ++c)
    sent[std::size_t(c)] = exact_contribution(light, at.point, min_distance, c);
  text += row_of("  contribution", [&](int c) { return text_of(sent[std::size_t(c)]); });
  return text + row_of("", [&](int c) {
           return fmt::format("{:a}", static_cast<double>(sent[std::size_t(c)]));
         });
}

std::string lights_text(const PointCase& at, std::uint32_t node) {
  const std::span<const std::uint32_t> all = at.topology().all_lights(node);
  std::vector<std::uint32_t> lights(all.begin(), all.end());
  std::sort(lights.begin(), lights.end());
  std::string text = "contribution = BRDF n.l falloff emission intensity\n";
  for (std::size_t i = 0; i < lights.size() && i < most_listed_lights; ++i)
    text += light_text(at, lights[i]);
  if (lights.size() > most_listed_lights)
    text += fmt::format("  ... and {} more lights\n", lights.size() - most_listed_lights);
  return text;
}

// ---- the library's bound of the same lights

/// A cluster of the library's: the subject's own where it has the library's tree, else one made of
/// the same lights.
struct LibraryCluster {
  std::optional<LightTree> made;
  const LightTree* tree;
  std::uint32_t node;

  LibraryCluster(const Judged& judged, const PointCase& at, std::uint32_t of)
      : tree(judged.tree.library_tree()), node(of) {
    if (tree != nullptr) return;
    LightSet lights;
    for (const std::uint32_t i : at.topology().all_lights(of)) lights.add(at.lights()[i]);
    if (at.lights().min_distance() > 0) lights.set_min_distance(at.lights().min_distance());
    made.emplace(build(lights));
    tree = &*made;
    node = 0;
  }
  LibraryCluster(const LibraryCluster&) = delete;
  LibraryCluster& operator=(const LibraryCluster&) = delete;

  [[nodiscard]] glm::vec3 bound(const ShadingPoint& point) const {
    if (tree->empty()) return glm::vec3(0);
    return contribution_bound(*tree, node, point);
  }
};

/// The suprema that the bound of a cluster of one kind is a product of.
struct Suprema {
  double max_cosine_falloff, falloff, emission = 1;
  glm::dvec3 shine{0}; ///< of lobe n.l falloff

  Suprema(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
    const TreeNode& n = tree.node(node);
    const glm::vec3 from = viewed_from(n.kind(), point.position());
    visit_kind(n.kind(), [&]<class Kind>(Kind) {
      const JointSuprema<Kind> sup;
      const double clamp2 = tree.min_distance2();
      max_cosine_falloff = sup.max_cosine_falloff(n.kind(), point.normal(), from, n.box, clamp2) *
                           point.inverse_normal_length();
      falloff = sup.max_falloff(n.kind(), from, n.box, clamp2);
      if (has_axis(Kind::kind)) emission = sup.max_emission(tree, node, n.kind(), from);
    });
    const auto bound_of = [&](const auto& lobe) {
      return lobe.bound(BoxSight{point, from, n.box, max_cosine_falloff, falloff});
    };
    if (max_cosine_falloff > 0) shine = std::visit(bound_of, point.material().lobe);
  }
};

std::string number_line(const char* name, double value, const char* note = "") {
  return line(name, fmt::format("{:.17g}", value), note);
}

std::string box_and_suprema(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  const TreeNode& n = tree.node(node);
  if (n.is_mixed())
    return box_and_suprema(tree, n.first_child, point) +
           box_and_suprema(tree, n.first_child + 1, point);
  const Suprema sup(tree, node, point);
  const glm::vec3 from = viewed_from(n.kind(), point.position());
  std::string text = fmt::format("the box of {} {} light{}, and suprema over it\n", n.light_count,
                                 name_of(n.kind()), n.light_count == 1 ? "" : "s");
  text += line("box from", text_of(n.box.lo)) + line("to", text_of(n.box.hi));
  if (!is_at_infinity(n.kind()))
    text += number_line("min |q|", std::sqrt(min_distance2(from, n.box)),
                        min_distance2(from, n.box) == 0 ? "the point is in the box" : "");
  text += number_line("max n.l falloff", sup.max_cosine_falloff, "both factors in one");
  text += number_line("max falloff", sup.falloff) + number_line("max emission", sup.emission);
  if (point.material().is_glossy()) text += number_row("max lobe n.l falloff", sup.shine);
  return text + number_row("intensity", n.intensity);
}

/// What the bound leaves for all that differs from light to light of a cluster of one kind, where
/// no lobe is in it: which of these factors is at fault, it does not tell.
std::string left_for_light(const LibraryCluster& cluster, const PointCase& at, std::uint32_t node,
                           int channel, double bound) {
  const TreeNode& n = cluster.tree->node(cluster.node);
  if (n.is_mixed() || at.point.material().is_glossy()) return {};
  const double others =
      n.intensity[channel] * at.point.material().diffuse[channel] * std::numbers::inv_pi;
  Exact most = 0;
  std::uint32_t brightest = 0;
  for (const std::uint32_t i : at.topology().all_lights(node)) {
    const Light& light = at.lights()[i];
    const radiometry::Way<Exact> way(at.point, light);
    if (way.n_dot_l <= 0) continue;
    const Exact share = way.n_dot_l * falloff(light, way, at.lights().min_distance()) *
                        radiometry::emission<Exact>(light, at.point, way.distance);
    if (share <= most) continue;
    most = share;
    brightest = i;
  }
  if (others == 0 || !std::isfinite(bound)) return {};
  return wrapped(fmt::format("  bound / (intensity diffuse/pi) leaves {:.9g} for n.l falloff{}; "
                             "light {} has {}",
                             bound / others, has_axis(n.kind()) ? " emission" : "", brightest,
                             text_of(most, 9)));
}

/// Nine digits, or what it is more or less than 1 where those do not show it.
std::string ratio_text(const Exact& ratio) {
  const Exact off = abs(Exact(ratio - 1));
  if (off == 0 || off > Exact(1e-8)) return text_of(ratio, 9);
  return fmt::format("1 {} {}", ratio > 1 ? '+' : '-', text_of(off, 3));
}

std::string parting(const LibraryCluster& cluster, const BothSides& sides, bool of_bound,
                    const PointCase& at, std::uint32_t node) {
  for (int c = 0; c < 3; ++c) {
    const auto k = std::size_t(c);
    const double bound = sides.right[k];
    const std::string where = fmt::format("they part here: channel {}, ", "rgb"[c]);
    if (sides.must_be_finite) {
      if (bound >= 0 && std::isfinite(bound)) continue;
      return wrapped(where + fmt::format("{} is {}, the truth {}", sides.right_name, bound,
                                         text_of(sides.left[k], 9)));
    }
    if (bound >= 0 && (!std::isfinite(bound) || Exact(bound) >= sides.left[k])) continue;
    std::string text = where + fmt::format("{} {} > {} {:.9g}", sides.left_name,
                                           text_of(sides.left[k], 9), sides.right_name, bound);
    if (bound > 0)
      text += fmt::format(", {} times", ratio_text(Exact(sides.left[k] / Exact(bound))));
    text = wrapped(text);
    if (of_bound) text += left_for_light(cluster, at, node, c, bound);
    return text;
  }
  return {};
}

std::string cluster_text(const PointAnswers& of, Property property, std::uint32_t node) {
  const PointCase& at = of.at;
  const glm::vec3& bound = of.bounds()[node];
  const std::uint32_t count = at.topology().light_count(node);
  const std::uint32_t representative = at.topology().representative(node);
  std::string text = fmt::format("node {} of {}: {} light{}", node, at.topology().size(), count,
                                 count == 1 ? "" : "s");
  if (representative != TreeClaim::unsaid)
    text += fmt::format(", represented by light {}", representative);
  const LibraryCluster cluster(of.judged, at, node);
  text += "\n" + lights_text(at, node) + "\n";
  if (!cluster.tree->empty()) text += box_and_suprema(*cluster.tree, cluster.node, at.point);
  text +=
      "bound = intensity max emission (diffuse/pi max(n.l falloff) + max(lobe n.l falloff))\n\n";
  const auto others = info(property).sides;
  const BothSides sides = others != nullptr ? others(of, node) : bound_sides(of, node);
  text += channel_head() + row_of("truth, 700 bits",
                                  [&](int c) { return text_of(at.truth.exact_open(node, c), 20); });
  text += sides.rows + number_row("the library's bound", cluster.bound(at.point));
  text += number_row("the subject's bound", bound);
  text += row_of("truth / its bound", [&](int c) -> std::string {
    if (bound[c] > 0 && std::isfinite(bound[c]))
      return ratio_text(Exact(at.truth.exact_open(node, c) / Exact(bound[c])));
    const double ratio = ratio_of(at.truth.open(node)[std::size_t(c)], bound[c]);
    return ratio == std::numeric_limits<double>::max() ? "inf" : fmt::format("{:.9g}", ratio);
  });
  return text + "\n" + parting(cluster, sides, others == nullptr, at, node);
}

} // namespace

std::string explain_cluster(const PointAnswers& of, Property property) {
  const auto node = failing_cluster(of, property);
  return node ? cluster_text(of, property, *node) : std::string();
}

} // namespace lightcuts::oracle
