// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/check.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/input_error.h>
#include <lightcuts/oracle/brute_force_occlusion.h>
#include <lightcuts/oracle/point_properties.h>
#include <lightcuts/oracle/random_pixels.h>
#include <lightcuts/oracle/white_furnace.h>

namespace lightcuts::oracle {
namespace {

/// Cuts of three kinds at each point: as configured, exact, and too small to converge.
struct Cuts {
  CutConfig config, exact, small;
  std::unique_ptr<Selector> configured_selector, exact_selector, small_selector;

  Cuts(const Subject& subject, const CutConfig& cut) : config(cut), exact(cut), small(cut) {
    exact.threshold = 0;
    exact.black_level = 0;
    exact.max_size = static_cast<std::uint32_t>(subject.tree().lights().size());
    small.max_size = 7;
    configured_selector = subject.selector(config);
    exact_selector = subject.selector(exact);
    small_selector = subject.selector(small);
  }
};

/// What one thread works with.
struct Worker {
  Tally tally;
  Truth truth;
  std::vector<char> visible;
  Cuts cuts;
  std::uint64_t rays = 0, undecided_rays = 0;

  Worker(const Subject& subject, const CutConfig& cut)
      : visible(subject.tree().lights().size()), cuts(subject, cut) {}
};

// Of the lights, so many at each point.
constexpr std::uint64_t reciprocal_lights = 4;

void check_material(const PointCase& at, const LightSet& lights, std::uint64_t seed, Tally& tally) {
  for (std::uint64_t i = 0; i < reciprocal_lights; ++i)
    check_reciprocity(at, lights[hashed(seed, reciprocal_lights * at.place + i) % lights.size()],
                      tally);
}

/// All different parts of the materials, as in a white furnace.
std::vector<Lobe> parts_of(const Scene& scene) {
  std::vector<Lobe> parts{NoLobe{}};
  for (const Surface& surface : scene.surfaces) {
    const auto whitened = [](const auto& lobe) { return white(lobe).lobe; };
    const Lobe part = std::visit(whitened, surface.material.lobe);
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  }
  return parts;
}

// Exact cuts cost N log N, the others much less: one point in eight has one.
constexpr std::uint64_t points_per_exact_cut = 8;

void check_point(const SceneView& view, const Subject& subject, std::uint64_t place,
                 const VisiblePoint& p, std::uint64_t seed, Worker& w) {
  for (std::uint32_t i = 0; i < w.visible.size(); ++i) w.visible[i] = view.sees(p, i) ? 1 : 0;
  w.truth.evaluate(subject.tree(), p.point, w.visible);
  const PointCase at{place, p.point, w.visible, w.truth};
  check_clusters(subject, at, w.tally);
  check_material(at, view.scene().lights, seed + 2, w.tally);

  const auto visible = [&w](std::uint32_t light) { return w.visible[light] != 0; };
  const auto check_selected = [&](Selector& selector, const CutConfig& config) {
    check_cut(subject, config, selector.select(p.point, visible), at, w.tally);
  };
  check_selected(*w.cuts.configured_selector, w.cuts.config);
  check_selected(*w.cuts.small_selector, w.cuts.small);
  if (place % points_per_exact_cut == 0) check_selected(*w.cuts.exact_selector, w.cuts.exact);
}

void check_ray(const SceneView& view, const VisiblePoint& from, std::uint64_t place,
               std::uint32_t light, Worker& w) {
  const Light& the_light = view.scene().lights[light];
  const glm::vec3& y = the_light.position;
  const ShadowRay ray = view.ray_to(from, light);
  // A light behind the surface is never asked for.
  if (transfer(from.point, the_light) == glm::dvec3(0)) return;
  ++w.rays;
  const Occlusion brute = brute_force_occlusion(view.scene().mesh, ray);
  if (brute == Occlusion::undecided) {
    ++w.undecided_rays;
    return;
  }
  const bool sees = view.sees(from, light);
  w.tally.record(Property::occlusion_equals_brute_force, sees == (brute == Occlusion::clear), place,
                 no_ratio, [&] {
                   const glm::vec3& o = ray.origin;
                   return fmt::format("from ({:.9g}, {:.9g}, {:.9g}) to light {} at ({:.9g}, "
                                      "{:.9g}, {:.9g}): {}, by brute force {}",
                                      o.x, o.y, o.z, light, y.x, y.y, y.z,
                                      sees ? "seen" : "blocked", sees ? "blocked" : "seen");
                 });
}

/// Enough for about a second of brute force.
std::uint64_t rays_to_check(const Scene& scene) {
  return std::clamp<std::uint64_t>(40'000'000 / scene.mesh.triangles.size(), 1000, 100'000);
}

using Clock = std::chrono::steady_clock;

} // namespace

CheckResult check(const SceneView& view, const Subject& subject, const CheckConfig& config) {
  const auto start = Clock::now();
  const LightTree& tree = subject.tree();
  if (tree.empty()) throw InputError(view.scene().name + ": no lights");
  CheckResult result;
  check_tree(tree, result.tally);

  result.points = config.pairs / tree.nodes().size() + (config.pairs % tree.nodes().size() != 0);
  result.pairs = result.points * tree.nodes().size();
  const std::uint64_t rays = rays_to_check(view.scene());
  std::atomic<std::uint64_t> done = 0;
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(subject, config.cut); });

  const auto check_points = [&](const tbb::blocked_range<std::uint64_t>& range) {
    Worker& w = workers.local();
    for (std::uint64_t i = range.begin(); i < range.end(); ++i) {
      const VisiblePoint p = random_point(view, config.seed, i);
      check_point(view, subject, i, p, config.seed, w);
      // The rays, dealt out evenly to the points.
      for (std::uint64_t r = i * rays / result.points; r < (i + 1) * rays / result.points; ++r)
        check_ray(view, p, i,
                  static_cast<std::uint32_t>(hashed(config.seed + 1, r) % tree.lights().size()), w);
    }
    const std::uint64_t now = done += range.size();
    if (config.progress) config.progress(double(now) / double(result.points));
  };
  tbb::task_arena arena(config.threads == 0 ? tbb::task_arena::automatic
                                            : static_cast<int>(config.threads));
  const std::vector<Lobe> parts = parts_of(view.scene());
  arena.execute([&] {
    tbb::parallel_for(std::size_t(0), parts.size(),
                      [&](std::size_t i) { check_energy(parts[i], i, workers.local().tally); });
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, result.points, 4), check_points,
                      tbb::simple_partitioner());
  });

  for (const Worker& w : workers) {
    result.tally.merge(w.tally);
    result.rays += w.rays;
    result.undecided_rays += w.undecided_rays;
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

} // namespace lightcuts::oracle
