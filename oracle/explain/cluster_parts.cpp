// SPDX-License-Identifier: MIT
#include <oracle/explain/cluster_parts.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/tree/tree_builder.h>
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

} // namespace

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

LibraryCluster::LibraryCluster(const Judged& judged, const PointCase& at, std::uint32_t of)
    : tree(judged.tree.library_tree()), node(of) {
  if (tree != nullptr) return;
  LightSet lights;
  for (const std::uint32_t i : at.topology().all_lights(of)) lights.add(at.lights()[i]);
  if (at.lights().min_distance() > 0) lights.set_min_distance(at.lights().min_distance());
  made.emplace(build(lights));
  tree = &*made;
  node = 0;
}

glm::vec3 LibraryCluster::bound(const ShadingPoint& point) const {
  return tree->empty() ? glm::vec3(0) : contribution_bound(*tree, node, point);
}

glm::vec3 LibraryCluster::bound(const ShadingBlock& block) const {
  return tree->empty() ? glm::vec3(0) : contribution_bound(*tree, node, block);
}

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

std::string truth_over(const PointCase& at, std::uint32_t node, const glm::vec3& bound) {
  return row_of("truth / its bound", [&](int c) -> std::string {
    if (bound[c] > 0 && std::isfinite(bound[c]))
      return ratio_text(Exact(at.truth.exact_open(node, c) / Exact(bound[c])));
    const double ratio = ratio_of(at.truth.open(node)[std::size_t(c)], bound[c]);
    return ratio == std::numeric_limits<double>::max() ? "inf" : fmt::format("{:.9g}", ratio);
  });
}

std::string cluster_head(const PointCase& at, std::uint32_t node) {
  const std::uint32_t count = at.topology().light_count(node);
  const std::uint32_t representative = at.topology().representative(node);
  std::string text = fmt::format("node {} of {}: {} light{}", node, at.topology().size(), count,
                                 count == 1 ? "" : "s");
  if (representative != TreeClaim::unsaid)
    text += fmt::format(", represented by light {}", representative);
  return text + "\n";
}

} // namespace lightcuts::oracle
