// SPDX-License-Identifier: MIT
#include <oracle/campaign/grazing_pairs.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/tree/tree_builder.h>

#include <oracle/cases/random_pixels.h>
#include <oracle/cases/stress_scene.h>
#include <oracle/truth/radiometry.h>

namespace lightcuts::oracle {
namespace {

using gen::Dice;
using Way = radiometry::Way<long double>;

/// The light is where the viewer is mirrored, or as much higher or lower as there are scales.
gen::Scene mirrored_at_a_power_of_two(Dice& dice, int exponent) {
  gen::Scene scene;
  const double up = std::ldexp(1.0, -exponent), across = std::sqrt(1 - up * up);
  const double x = dice.one_in(4) ? 0 : across * dice.uniform(0, 1);
  const double z = std::sqrt(std::max(0.0, across * across - x * x));
  scene.view.normal = {0, 1, 0};
  scene.view.to_viewer = glm::vec3(x, up, z);
  const bool apart = dice.one_in(2);
  for (int i = 0; i < 2; ++i) {
    const int other = apart ? dice.between(1, 149) : exponent;
    const double distance = std::ldexp(1.0, dice.one_in(2) ? 1 : dice.between(-20, 20));
    const glm::dvec3 v(scene.view.to_viewer);
    Light light;
    light.position = glm::vec3(distance * glm::dvec3(-v.x, std::ldexp(1.0, -other), -v.z));
    light.intensity = glm::vec3(1);
    scene.lights.push_back(light);
  }
  return scene;
}

/// Every lobe, of several widths.
std::vector<Material> materials(Dice& dice) {
  std::vector<Material> list;
  const auto add = [&](const Lobe& lobe) {
    list.push_back({dice.one_in(3) ? dice.reflectance() : glm::vec3(0), lobe});
  };
  list.push_back({dice.reflectance(), NoLobe()});
  for (const float exponent : {1.0F, 30.0F, 0x1p20F}) add(Phong{glm::vec3(1), exponent});
  for (const float alpha : {0x1p-14F, 1e-3F, 0.01F, 0.1F, 1.0F}) {
    add(Ward{glm::vec3(1), alpha});
    add(CookTorrance{glm::vec3(0, 0.04F, 1), alpha});
  }
  for (std::size_t lobe = 1; lobe < std::variant_size_v<Lobe>; ++lobe)
    for (int i = 0; i < 2; ++i) add(radiometry::random_lobe(dice, lobe));
  return list;
}

/// What transfer.h states, one by one: of n.l and falloff, emission, and the lobe.
double stated_error(const Lobe& lobe, LightKind kind) {
  double error = 0x1p-34;
  if (kind == LightKind::oriented) error += 0x1p-34;
  if (kind == LightKind::spot || kind == LightKind::profile) error += 0x1p-31;
  if (std::holds_alternative<Phong>(lobe)) error += 0x1p-28;
  if (std::holds_alternative<Ward>(lobe)) error += 0x1.ap-28; // 2^-27.3
  if (std::holds_alternative<CookTorrance>(lobe)) error += 0x1p-30;
  return std::min(error, transfer_error);
}

/// Lights of one kind, with what is the same for all materials.
class LightsOfKind {
public:
  /// ways: to the lights, where another kind has the same; else as many as wanted are added.
  LightsOfKind(Dice& dice, const gen::Scene& scene, LightKind kind, const ShadingPoint& point,
               std::deque<Way>& ways)
      : kind_(kind), ways_(ways) {
    LightSet set;
    for (Light light : scene.lights) {
      const glm::dvec3 from(is_at_infinity(light.kind) ? glm::vec3(0) : point.position());
      const glm::dvec3 q = glm::dvec3(light.position) - from;
      const bool is_somewhere = glm::length(q) > 0;
      const glm::dvec3 l = is_somewhere ? glm::normalize(q) : glm::dvec3(0, 1, 0);
      light.kind = kind;
      if (is_at_infinity(kind))
        light.position = glm::vec3(l);
      else
        gen::finish(dice, light, point.position());
      if (has_axis(kind) && dice.one_in(2)) light.axis = glm::vec3(-l);
      set.add(light);
      if (ways.size() < set.size()) ways.emplace_back(point, light);
    }
    if (scene.min_distance > 0) set.set_min_distance(scene.min_distance);
    tree_ = build(set);
    selectors_.emplace_back(tree_, CutConfig{0.1F, 1, 0});
    selectors_.emplace_back(tree_, CutConfig{0, 1000, 0, true});
  }
  LightsOfKind(const LightsOfKind&) = delete;
  LightsOfKind& operator=(const LightsOfKind&) = delete;

  [[nodiscard]] LightKind kind() const { return kind_; }
  [[nodiscard]] const LightTree& tree() const { return tree_; }
  [[nodiscard]] std::deque<CutSelector>& selectors() { return selectors_; }
  /// Per unit of intensity.
  [[nodiscard]] Wide transfer(std::size_t light, const Material& material) const {
    Light one = tree_.lights()[light];
    one.intensity = glm::vec3(1);
    return radiometry::contribution(one, ways_[light], material, tree_.lights().min_distance());
  }

private:
  LightKind kind_;
  LightTree tree_;
  const std::deque<Way>& ways_;
  std::deque<CutSelector> selectors_; ///< of a cut of the root alone, and of all lights
};

/// Compares for one material and kind of light.
class Comparison {
public:
  Comparison(const GrazingAnswers& of, LightsOfKind& lights, const ShadingPoint& point,
             GrazingCount& count)
      : of_(of), lights_(lights), tree_(lights.tree()), point_(point), count_(count) {
    for (std::size_t i = 0; i < tree_.lights().size(); ++i)
      transfers_.push_back(lights.transfer(i, point.material()));
    sums_.resize(tree_.nodes().size());
    for (auto i = std::uint32_t(sums_.size()); i-- > 0;) sums_[i] = sum_of(i);
  }

  void transfers() {
    const double stated = stated_error(point_.material().lobe, lights_.kind());
    for (std::size_t i = 0; i < transfers_.size(); ++i) {
      Light light = tree_.lights()[i];
      light.intensity = glm::vec3(1);
      const float clamp = tree_.lights().min_distance();
      const glm::dvec3 found = of_.transfer(point_, light, clamp);
      check(GrazingCheck::transfer, std::uint32_t(i), [&](int c) {
        const long double truth = transfers_[i][std::size_t(c)];
        const long double limit = stated * truth + least_transfer;
        const long double off = std::abs(found[c] - truth);
        if (truth * stated > least_transfer)
          count_.worst_transfer = std::max(count_.worst_transfer, double(off / (truth * stated)));
        return at_most(off, limit, truth * truth_error, [&] {
          const Exact exact = exact_contribution(light, point_, clamp, c);
          return abs(Exact(found[c]) - exact) <= exact * Exact(stated) + Exact(least_transfer);
        });
      });
    }
  }

  void bounds(const ShadingBlock& block) {
    for (std::uint32_t i = 0; i < sums_.size(); ++i) {
      upper(GrazingCheck::bound, i, of_.bound(tree_, i, point_));
      upper(GrazingCheck::block_bound, i, of_.bound(tree_, i, block));
      const glm::vec3 low = of_.lower_bound(tree_, i, point_);
      check(GrazingCheck::lower_bound, i, [&](int c) {
        const long double truth = sums_[i][std::size_t(c)];
        return at_most(low[c], truth, truth * truth_error,
                       [&] { return Exact(low[c]) <= exact_sum(i, c); });
      });
    }
  }

  void certificates() {
    std::uint32_t which = 0;
    for (CutSelector& select : lights_.selectors()) {
      const Cut cut = of_.cut(select, point_);
      check(GrazingCheck::certificate, which++, [&](int c) {
        const float certified = cut.certified_error[c];
        if (std::isinf(certified)) return true;
        const long double truth = sums_[0][std::size_t(c)];
        return at_most(std::abs(cut.radiance[c] - truth), certified, truth * truth_error, [&] {
          return abs(Exact(cut.radiance[c]) - exact_sum(0, c)) <= Exact(certified);
        });
      });
    }
  }

private:
  [[nodiscard]] Wide sum_of(std::uint32_t node) const {
    const TreeNode& n = tree_.node(node);
    Wide sum;
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] = n.is_leaf() ? transfers_[n.representative][c] *
                                 tree_.lights()[n.representative].intensity[int(c)]
                           : sums_[n.first_child][c] + sums_[n.first_child + 1][c];
    return sum;
  }
  [[nodiscard]] Exact exact_sum(std::uint32_t node, int c) const {
    const TreeNode& n = tree_.node(node);
    if (n.is_leaf())
      return exact_contribution(tree_.lights()[n.representative], point_,
                                tree_.lights().min_distance(), c);
    return exact_sum(n.first_child, c) + exact_sum(n.first_child + 1, c);
  }

  void upper(GrazingCheck what, std::uint32_t node, const glm::vec3& bound) {
    check(what, node, [&](int c) {
      const long double truth = sums_[node][std::size_t(c)];
      return dominates(bound[c], truth, truth * truth_error, [&] {
        ++count_.exact;
        return exact_sum(node, c);
      });
    });
  }

  /// Whether a <= b, of which one is known to within margin; NaN is not.
  template <class Decide>
  bool at_most(long double a, long double b, long double margin, const Decide& decide) {
    if (a + margin <= b) return true;
    if (!(a - margin <= b)) return false;
    ++count_.exact;
    return decide();
  }

  template <class Holds>
  void check(GrazingCheck what, std::uint32_t index, const Holds& holds) {
    ++count_.checks[std::size_t(what)];
    for (int c = 0; c < 3; ++c) {
      if (holds(c)) continue;
      if (++count_.violations == 1)
        count_.first_violation = fmt::format(
            "check {} of {} (of kind {}), channel {}, lobe {}", int(what), index,
            name_of(lights_.kind()), c,
            std::visit([](const auto& lobe) { return lobe.name; }, point_.material().lobe));
      return;
    }
  }

  const GrazingAnswers& of_;
  LightsOfKind& lights_;
  const LightTree& tree_;
  const ShadingPoint& point_;
  GrazingCount& count_;
  std::vector<Wide> transfers_, sums_; ///< per light, for an intensity of 1; per node
};

} // namespace

glm::dvec3 GrazingAnswers::transfer(const ShadingPoint& point, const Light& light,
                                    float min_distance) const {
  return lightcuts::transfer(point, light, min_distance);
}
glm::vec3 GrazingAnswers::bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const {
  return contribution_bound(tree, node, point);
}
glm::vec3 GrazingAnswers::bound(const LightTree& tree, std::uint32_t node,
                                const ShadingBlock& block) const {
  return contribution_bound(tree, node, block);
}
glm::vec3 GrazingAnswers::lower_bound(const LightTree& tree, std::uint32_t node,
                                      const ShadingPoint& point) const {
  return contribution_lower_bound(tree, node, point);
}
Cut GrazingAnswers::cut(CutSelector& select, const ShadingPoint& point) const {
  return select(point, [](std::uint32_t /*light*/) { return true; });
}

std::uint64_t GrazingCount::all_checks() const {
  return std::accumulate(checks.begin(), checks.end(), std::uint64_t(0));
}

void GrazingCount::merge(const GrazingCount& other) {
  pairs += other.pairs;
  for (std::size_t i = 0; i < checks.size(); ++i) checks[i] += other.checks[i];
  exact += other.exact;
  if (violations == 0) first_violation = other.first_violation;
  violations += other.violations;
  worst_transfer = std::max(worst_transfer, other.worst_transfer);
}

GrazingCount check_grazing_pair(const GrazingAnswers& of, std::uint64_t seed, std::uint64_t index) {
  Dice dice(hashed(seed, index));
  constexpr std::uint64_t scales = 149;
  const gen::Scene scene = index % 2 == 0
                               ? mirrored_at_a_power_of_two(dice, int(index / 2 % scales) + 1)
                               : gen::make_grazing_scene(dice, 2);
  const ShadingPoint base = scene.view.point();
  GrazingCount count;
  count.pairs = 1;
  // To where the lights are, and to those at infinity in the same direction.
  std::deque<Way> ways, ways_from_afar;
  std::deque<LightsOfKind> kinds;
  for (int kind = 0; kind < light_kind_count; ++kind)
    kinds.emplace_back(dice, scene, LightKind(kind), base,
                       is_at_infinity(LightKind(kind)) ? ways_from_afar : ways);
  gen::View neighbour = scene.view;
  neighbour.position += 1e-3F * dice.in_cube();
  if (dice.one_in(2)) neighbour.normal = -glm::vec3(glm::normalize(glm::dvec3(neighbour.normal)));
  for (const Material& material : materials(dice)) {
    gen::View view = scene.view;
    view.material = neighbour.material = material;
    const std::array points{view.point(), neighbour.point()};
    const ShadingBlock block(points);
    for (LightsOfKind& lights : kinds) {
      Comparison comparison(of, lights, points[0], count);
      comparison.transfers();
      comparison.bounds(block);
      comparison.certificates();
    }
  }
  if (count.violations > 0)
    count.first_violation = fmt::format("seed {}, pair {}: ", seed, index) + count.first_violation;
  return count;
}

} // namespace lightcuts::oracle
