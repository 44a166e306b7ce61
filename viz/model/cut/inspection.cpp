// SPDX-License-Identifier: MIT
#include <viz/model/cut/inspection.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include <glm/geometric.hpp>
#include <lightcuts/core/numerics/exact_dot.h>
#include <oracle/properties/point_case.h>
#include <oracle/truth/clairvoyant.h>

#include <viz/model/picture/lit_square.h>

namespace lightcuts::viz {
namespace {

/// What is looked at: a pixel's point, or a counterexample's.
class Place {
public:
  explicit Place(const InspectionKey& key)
      : key_(key), scene_(*key.frame.scene), view_(view_for(key.frame)) {
    if (const auto& c = scene_.counterexample()) {
      const oracle::CaseView& view = c->saved.counterexample.on.views[c->view];
      const ShadingPoint point = view.view.point();
      visible_.emplace(VisiblePoint{point, point.position(), glm::vec3(0)});
      hidden_.insert(view.hidden.begin(), view.hidden.end());
    } else if (glm::all(glm::lessThan(key.pixel, view_.size()))) {
      if (auto p = view_.at(key.pixel)) visible_.emplace(*p);
    }
  }

  [[nodiscard]] bool sees_surface() const { return visible_.has_value(); }
  [[nodiscard]] const VisiblePoint& visible() const { return *visible_; }
  [[nodiscard]] const ShadingPoint& point() const { return visible_->point; }
  [[nodiscard]] const OpenedScene& scene() const { return scene_; }
  [[nodiscard]] bool sees(std::uint32_t light) const {
    return scene_.counterexample() ? !hidden_.contains(light) : view_.sees(*visible_, light);
  }
  /// As cuts have it: a light below the horizon counts as seen.
  [[nodiscard]] bool counts_as_seen(std::uint32_t light) const {
    const Light& l = scene_.scene().lights[light];
    const glm::vec3 from = viewed_from(l.kind, point().position());
    return dot_between(point().normal(), from, l.position) <= 0 || sees(light);
  }
  [[nodiscard]] CutConfig config() const { return cut_config(key_.frame.settings, scene_, view_); }
  /// Whether the tree answers that; a foreign one may not.
  [[nodiscard]] bool offers(oracle::Part part) const { return has(scene_.parts(), part); }
  [[nodiscard]] std::unique_ptr<oracle::SubjectTree> tree() const {
    return tree_for(key_.frame.method, key_.frame.settings, scene_);
  }

  /// The cut with max_size clusters at most, by the key's method; valid as the tree's is.
  [[nodiscard]] Cut cut(oracle::SubjectTree& tree, std::uint32_t max_size) const {
    CutConfig config = this->config();
    config.max_size = max_size;
    const auto sees_light = [this](std::uint32_t light) { return sees(light); };
    if (key_.frame.method == methods::block_cuts && !scene_.counterexample())
      return cut_in_square(config);
    if (!key_.frame.method->draws || scene_.counterexample())
      return tree.select(point(), config, sees_light);
    const std::uint64_t query =
        std::uint64_t(key_.pixel.y) * view_.size().x + key_.pixel.x; // as the renderer has it
    return tree.draw(point(), config, query, sees_light);
  }

  /// Of each cluster of the last cut().
  [[nodiscard]] std::vector<std::optional<Sight>> sights(const Cut& cut) const {
    if (lit_) return lit_->sights(lit_->index_of(key_.pixel));
    std::vector<std::optional<Sight>> sights;
    for (const CutCluster& cluster : cut.clusters) {
      std::optional<Sight>& sight = sights.emplace_back();
      if (config().unoccluded)
        sight = Sight::seen;
      else if (scene_.topology().representative(cluster.node) != oracle::TreeClaim::unsaid &&
               !(cluster.visible &&
                 cluster.estimate == glm::dvec3(0))) // no ray is cast for nothing
        sight = Sight::ray;
    }
    return sights;
  }
  /// The pixels that shared the last cut(); empty where its method lights each alone.
  [[nodiscard]] std::vector<glm::uvec2> block() const {
    std::vector<glm::uvec2> block;
    if (lit_)
      for (const std::uint32_t p : lit_->block(lit_->index_of(key_.pixel)))
        block.push_back(lit_->pixels()[p]);
    return block;
  }

private:
  /// What the pixel gets where its square is lit, as the renderer does it.
  [[nodiscard]] Cut cut_in_square(const CutConfig& config) const {
    lit_.emplace(view_, *scene_.tree(), config, key_.frame.settings.seed, key_.pixel);
    const std::size_t own = lit_->index_of(key_.pixel);
    const BlockCut& cut = lit_->cut(own);
    return {.radiance = cut.radiance,
            .certified_error = cut.certified_error,
            .clusters = lit_->clusters(own),
            .shadow_rays = cut.shadow_rays,
            .end = cut.end};
  }

  const InspectionKey& key_;
  const OpenedScene& scene_;
  SceneView view_;
  std::optional<VisiblePoint> visible_;
  std::unordered_set<std::uint32_t> hidden_;
  mutable std::optional<LitSquare> lit_; ///< by the last cut() of a method that shares
};

/// Distance to the nearest point of the box, metres.
double distance_to(const Box& box, const glm::vec3& from) {
  const glm::dvec3 at(from);
  return glm::distance(glm::clamp(at, glm::dvec3(box.lo), glm::dvec3(box.hi)), at);
}

/// Of a directional light, a point on the way to it.
glm::vec3 shown_at(const Light& light, const glm::vec3& from) {
  return is_at_infinity(light.kind) ? from + light.position : light.position;
}

/// The box of all lights below, whatever tree it is.
void add_geometry(const OpenedScene& scene, const glm::vec3& from, ClusterRow& row) {
  if (row.representative != oracle::TreeClaim::unsaid) {
    const Light& light = scene.scene().lights[row.representative];
    row.representative_position = shown_at(light, from);
    if (is_at_infinity(light.kind)) return;
    row.distance = glm::distance(glm::dvec3(light.position), glm::dvec3(from));
  }
  Box box = Box::empty();
  for (const std::uint32_t light : scene.topology().all_lights(row.node)) {
    if (is_at_infinity(scene.scene().lights[light].kind)) return;
    box.lo = glm::min(box.lo, scene.scene().lights[light].position);
    box.hi = glm::max(box.hi, scene.scene().lights[light].position);
  }
  row.box = box;
  row.has_box = true;
  row.distance = distance_to(box, from);
}

/// The box as the tree has it, where it is the library's: no need to look at all lights.
void add_library_box(const LightTree& tree, const glm::vec3& from, ClusterRow& row) {
  const TreeNode& node = tree.node(row.node);
  row.representative_position = shown_at(tree.lights()[node.representative], from);
  if (node.is_mixed() || is_at_infinity(node.kind())) return;
  row.box = node.box;
  row.has_box = true;
  row.distance = distance_to(node.box, from);
}

/// The largest bound / max(threshold total, black level) of the channels.
double share_of(const glm::vec3& bound, const glm::dvec3& total, const CutConfig& config) {
  double share = 0;
  for (int c = 0; c < 3; ++c) {
    const double allowed = std::max<double>(config.threshold * total[c], config.black_level);
    if (bound[c] > 0)
      share = std::max(share,
                       allowed > 0 ? bound[c] / allowed : std::numeric_limits<double>::infinity());
  }
  return share;
}

ClusterRow row_for(const Place& place, const CutCluster& cluster, const CutConfig& config,
                   const glm::dvec3& total) {
  const oracle::Topology& topology = place.scene().topology();
  ClusterRow row{};
  row.node = cluster.node;
  row.depth = place.scene().depth(cluster.node);
  row.lights = topology.light_count(cluster.node);
  row.intensity = topology.intensity(cluster.node).value_or(glm::dvec3(0));
  row.representative = topology.representative(cluster.node);
  row.visible = cluster.visible;
  row.bound = cluster.bound;
  row.estimate = cluster.estimate;
  row.share = share_of(cluster.bound, total, config);
  if (place.scene().counterexample())
    add_geometry(place.scene(), place.point().position(), row);
  else
    add_library_box(*place.scene().tree(), place.point().position(), row);
  return row;
}

glm::dvec3 total_of(const Cut& cut) {
  glm::dvec3 total(0);
  for (const CutCluster& c : cut.clusters) total += c.estimate;
  return total;
}

/// The node of the one cut that the other does not have: what was refined between them.
std::optional<std::uint32_t> refined_between(const Cut& before, oracle::SubjectTree& tree,
                                             const Place& place) {
  std::unordered_set<std::uint32_t> nodes;
  for (const CutCluster& c : before.clusters) nodes.insert(c.node);
  const Cut after = place.cut(tree, std::uint32_t(nodes.size() + 1));
  for (const CutCluster& c : after.clusters) nodes.erase(c.node);
  return nodes.size() == 1 ? std::optional(*nodes.begin()) : std::nullopt;
}

void describe_point(const Place& place, Inspection& inspection) {
  inspection.sees_surface = true;
  inspection.position = place.point().position();
  inspection.normal = place.point().normal();
  inspection.to_viewer = place.point().to_viewer();
  inspection.material = place.point().material();
  inspection.emission = place.visible().emission;
}

/// As it is in a cut: a single light has no error.
CutCluster cluster_of(const Place& place, oracle::SubjectTree& tree, std::uint32_t node) {
  const oracle::Topology& topology = place.scene().topology();
  const std::uint32_t representative = topology.representative(node);
  const glm::vec3 bound = tree.bound(node, place.point());
  CutCluster cluster{node, true, glm::dvec3(0), bound};
  if (topology.light_count(node) == 1) cluster.bound = glm::vec3(0);
  cluster.visible =
      representative == oracle::TreeClaim::unsaid || place.counts_as_seen(representative);
  if (cluster.visible) cluster.estimate = tree.estimate(node, place.point(), bound);
  return cluster;
}

double channel_sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// What is true at the place, of all clusters.
struct PlaceTruth {
  std::vector<char> visible;
  oracle::Truth truth;
};

bool evaluate(const Place& place, const Progress& progress, PlaceTruth& result) {
  const LightSet& lights = place.scene().scene().lights;
  result.visible.resize(lights.size());
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (i % 4096 == 0 && progress.cancelled()) return false;
    result.visible[i] = place.sees(i) ? 1 : 0;
  }
  result.truth.evaluate(place.scene().topology(), lights, place.point(), result.visible);
  return true;
}

glm::dvec3 as_doubles(const oracle::Wide& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

} // namespace

Inspection inspect(const InspectionKey& key) {
  Inspection inspection;
  const Place place(key);
  if (!place.sees_surface()) return inspection;
  describe_point(place, inspection);
  inspection.config = place.config();
  if (!place.offers(oracle::Part::cuts)) return inspection;
  const auto tree = place.tree();
  Cut cut = place.cut(*tree, inspection.config.max_size);
  inspection.final_size = std::uint32_t(cut.clusters.size());
  if (key.step && *key.step < inspection.final_size)
    cut = place.cut(*tree, std::max(1U, *key.step));
  inspection.radiance = cut.radiance;
  inspection.certified_error = cut.certified_error;
  inspection.end = cut.end;
  inspection.shadow_rays = cut.shadow_rays;
  const glm::dvec3 total = total_of(cut);
  const std::vector<std::optional<Sight>> sights = place.sights(cut);
  for (std::size_t i = 0; i < cut.clusters.size(); ++i) {
    inspection.clusters.push_back(row_for(place, cut.clusters[i], inspection.config, total));
    inspection.clusters.back().sight = sights[i];
  }
  inspection.block = place.block();
  if (cut.clusters.size() < inspection.final_size)
    inspection.refined_next = refined_between(cut, *tree, place);
  return inspection;
}

RefinementCurve refinement_curve(const InspectionKey& key, std::size_t most,
                                 const Progress& progress) {
  RefinementCurve curve;
  const Place place(key);
  if (!place.sees_surface() || !place.offers(oracle::Part::cuts)) return curve;
  const auto tree = place.tree();
  const auto last = double(place.cut(*tree, place.config().max_size).clusters.size());
  // Evenly in logarithm: the first refinements do most.
  std::uint32_t before = 0;
  const double steps = double(std::max<std::size_t>(most, 2) - 1);
  for (double i = 0; i <= steps && !progress.cancelled(); ++i) {
    const auto size = std::uint32_t(std::lround(std::pow(last, i / steps)));
    if (size <= before) continue;
    before = size;
    const Cut cut = place.cut(*tree, size);
    double largest = 0;
    for (const CutCluster& c : cut.clusters) largest = std::max(largest, channel_sum(c.bound));
    curve.size.push_back(double(cut.clusters.size()));
    curve.total.push_back(channel_sum(total_of(cut)));
    curve.certified.push_back(channel_sum(cut.certified_error));
    curve.largest_bound.push_back(largest);
  }
  return curve;
}

bool add_truth(const InspectionKey& key, Inspection& inspection, const Progress& progress) {
  const Place place(key);
  if (!place.sees_surface()) return true;
  PlaceTruth known;
  if (!evaluate(place, progress, known)) return false;
  for (ClusterRow& row : inspection.clusters) row.truth = as_doubles(known.truth.seen(row.node));
  inspection.truth = as_doubles(known.truth.seen(0));
  if (!place.offers(oracle::Part::bounds) || !place.offers(oracle::Part::estimates)) return true;
  const auto tree = place.tree();
  const oracle::Judged judged{*tree, place.scene().parts()};
  const oracle::PointCase at{0, place.point(), known.visible, known.truth};
  const auto estimate = [&](std::uint32_t node) { return seen_estimate(judged, node, at); };
  inspection.clairvoyant = clairvoyant_cut_size(known.truth, estimate, inspection.config.threshold,
                                                inspection.config.black_level);
  return true;
}

std::optional<ClusterRow> row_of(const InspectionKey& key, std::uint32_t node) {
  const Place place(key);
  const oracle::Topology& topology = place.scene().topology();
  if (!place.sees_surface() || node >= topology.size()) return std::nullopt;
  for (const oracle::Part part :
       {oracle::Part::bounds, oracle::Part::estimates, oracle::Part::cuts})
    if (!place.offers(part)) return std::nullopt;
  const auto tree = place.tree();
  const CutCluster cluster = cluster_of(place, *tree, node);
  const Cut cut = place.cut(*tree, place.config().max_size);
  return row_for(place, cluster, place.config(), total_of(cut));
}

} // namespace lightcuts::viz
