// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/check.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/input_error.h>
#include <lightcuts/oracle/case_properties.h>
#include <lightcuts/oracle/random_pixels.h>
#include <lightcuts/oracle/white_furnace.h>

namespace lightcuts::oracle {
namespace {

/// Cuts of three kinds at each point: as configured, exact, and too small to converge.
struct Cuts {
  CutConfig config, exact, small;

  Cuts(const CutConfig& cut, std::size_t lights) : config(cut), exact(cut), small(cut) {
    exact.threshold = 0;
    exact.black_level = 0;
    exact.max_size = static_cast<std::uint32_t>(lights);
    small.max_size = small_cut_size;
  }
};

/// What one thread works with.
struct Worker {
  Tally tally;
  Truth truth;
  std::unique_ptr<SubjectTree> tree; ///< made where it is wanted: a subject may fail to
  std::vector<char> visible;
  RayCount rays;
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
// So does asking for the probabilities of all lights of all clusters, and more.
constexpr std::uint64_t points_per_probabilities = 64;

void check_point(const SceneView& view, Parts parts, const Topology& topology, const Cuts& cuts,
                 std::uint64_t place, const VisiblePoint& p, std::uint64_t seed, Worker& w) {
  const LightSet& lights = view.scene().lights;
  for (std::uint32_t i = 0; i < w.visible.size(); ++i) w.visible[i] = view.sees(p, i) ? 1 : 0;
  w.truth.evaluate(topology, lights, p.point, w.visible);
  const PointCase at{place, p.point, w.visible, w.truth};
  const Judged judged{*w.tree, parts};
  check_clusters(judged, at, w.tally);
  check_material(at, lights, seed + 2, w.tally);
  if (judged.has(Part::sampling) && place % points_per_probabilities == 0)
    check_probabilities(judged, at, w.tally);
  if (!judged.has(Part::cuts)) return;

  const auto visible = [&w](std::uint32_t light) {
    return light < w.visible.size() && w.visible[light] != 0;
  };
  const auto check_selected = [&](const CutConfig& config) {
    check_cut(judged, config, w.tree->select(p.point, config, visible), at, w.tally);
  };
  check_selected(cuts.config);
  check_selected(cuts.small);
  if (place % points_per_exact_cut == 0) check_selected(cuts.exact);
}

/// Records what the work throws as SubjectFailure, and whether it did not.
template <class Work>
bool answers(std::uint64_t place, Tally& tally, Work&& work) {
  std::string failure;
  try {
    work();
  } catch (const SubjectFailure& e) {
    failure = e.what();
  }
  tally.record(Property::subject_answers, failure.empty(), place, no_ratio,
               [&] { return failure; });
  return failure.empty();
}

/// Enough for about a second of brute force.
std::uint64_t rays_to_check(const Scene& scene) {
  return std::clamp<std::uint64_t>(40'000'000 / scene.mesh.triangles.size(), 1000, 100'000);
}

using Clock = std::chrono::steady_clock;

} // namespace

CheckResult check(const SceneView& view, const Subject& subject, const CheckConfig& config) {
  const auto start = Clock::now();
  const LightSet& lights = view.scene().lights;
  if (lights.empty()) throw InputError(view.scene().name + ": no lights");
  CheckResult result;
  std::unique_ptr<SubjectTree> tree;
  std::optional<Topology> topology;
  const bool is_built = answers(0, result.tally, [&] {
    if (has(subject.parts(), Part::refinement_order))
      check_refinement_order(subject, 0, result.tally);
    tree = subject.build(lights, config.tree_seed);
    topology = check_tree(tree->claim(), lights, 0, result.tally);
  });
  if (!is_built || !topology) return result;

  result.points = config.pairs / topology->size() + (config.pairs % topology->size() != 0);
  result.pairs = result.points * topology->size();
  const Cuts cuts(config.cut, lights.size());
  const std::uint64_t rays =
      has(subject.parts(), Part::occlusion) ? rays_to_check(view.scene()) : 0;
  std::atomic<std::uint64_t> done = 0;
  tbb::enumerable_thread_specific<Worker> workers;
  std::atomic<bool> failed = false; // one that has failed once is asked no more
  std::mutex tree_mutex;            // copies of one tree are made one at a time

  const auto check_one = [&](std::uint64_t i, const VisiblePoint& p, Worker& w) {
    if (!w.tree) {
      const std::lock_guard lock(tree_mutex);
      w.tree = tree->for_another_thread();
      w.visible.resize(lights.size());
    }
    check_point(view, subject.parts(), *topology, cuts, i, p, config.seed, w);
  };
  const auto check_points = [&](const tbb::blocked_range<std::uint64_t>& range) {
    Worker& w = workers.local();
    for (std::uint64_t i = range.begin(); i < range.end() && !failed; ++i) {
      const VisiblePoint p = random_point(view, config.seed, i);
      if (!answers(i, w.tally, [&] { check_one(i, p, w); })) failed = true;
      // The rays, dealt out evenly to the points.
      for (std::uint64_t r = i * rays / result.points; r < (i + 1) * rays / result.points; ++r)
        check_ray(subject, view, p,
                  static_cast<std::uint32_t>(hashed(config.seed + 1, r) % lights.size()), i, w.rays,
                  w.tally);
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
    result.rays += w.rays.rays;
    result.undecided_rays += w.rays.undecided;
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

} // namespace lightcuts::oracle
