// SPDX-License-Identifier: MIT
#include <oracle/campaign/check.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/render/view/pixel_square.h>
#include <oracle/campaign/scene_case.h>
#include <oracle/cases/random_pixels.h>
#include <oracle/properties/bounds/bound_sweep.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/judge.h>
#include <oracle/truth/white_furnace.h>

namespace lightcuts::oracle {
namespace {

/// What one thread works with.
struct Worker {
  Tally tally;
  Truth truth;
  std::unique_ptr<SubjectTree> tree; ///< made where it is wanted: a subject may fail to
  std::vector<char> visible;
  std::optional<BoundSweep> sweep;
  RayCount rays;
  std::uint64_t swept_pairs = 0;
  double sweep_seconds = 0;
};

// Of the lights, so many at each point.
constexpr std::uint64_t reciprocal_lights = 4;

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
constexpr std::uint64_t points_per_probabilities = 64 * points_per_full_check;
constexpr std::uint64_t points_per_excerpt = points_per_full_check;
// What is proven of a square of pixels is compared with brute force, for so many rays of it.
constexpr std::uint64_t points_per_proof = points_per_full_check, rays_per_proof = 64;

void check_point(const CheckConfig& config, const PointCase& at, const Judged& judged,
                 Tally& tally) {
  const LightSet& lights = at.lights();
  const Judge judge(judged.parts, at.place, tally);
  const PointAnswers answers(judged, at);
  judge.clusters(answers);
  for (std::uint64_t i = 0; i < reciprocal_lights; ++i) {
    const std::uint64_t random = hashed(config.seed + 2, reciprocal_lights * at.place + i);
    judge.light(at.point, lights[random % lights.size()]);
  }
  if (at.place % points_per_probabilities == 0) judge.odds(answers);
  const auto cuts = cuts_of(config.cut, lights.size());
  if (at.place % points_per_exact_cut == 0)
    judge.cuts(answers, cuts);
  else
    judge.cuts(answers, std::array{cuts[0], cuts[2]});
}

/// Rays per shading point, so that brute force takes a tenth of the time or so; where triangles are
/// few, a ray takes time all the same.
double ray_rate(const Scene& scene, const Topology& topology) {
  return std::min(2 * double(topology.size()) / double(scene.mesh.triangles.size()), 500.0);
}

constexpr double seconds_per_checkpoint = 30;

/// One run of check(), from a block of points to the next.
class Campaign {
public:
  Campaign(const SceneView& view, const Subject& subject, const CheckConfig& config,
           const CheckResult& done)
      : view_(view), lights_(view.scene().lights), subject_(subject), config_(config),
        result_(done),
        arena_(config.threads == 0 ? tbb::task_arena::automatic : int(config.threads)) {
    result_.complete = true;
  }

  [[nodiscard]] CheckResult run() {
    Tally first;
    if (!build(first)) {
      result_.tally.merge(first);
      result_.complete = false;
      return finished();
    }
    const std::uint64_t nodes = topology_->size();
    const std::uint64_t points = config_.pairs / nodes + (config_.pairs % nodes != 0);
    if (result_.points == 0) {
      result_.tally.merge(first);
      check_materials();
    }
    while (result_.points < points && result_.complete) {
      check_block(result_.points, std::min(points, result_.points + block_size()));
      collect();
      config_.progress.report(double(result_.points) / double(points));
      if (config_.checkpoint && seconds_since(saved_) >= seconds_per_checkpoint) {
        config_.checkpoint(result_);
        saved_ = Clock::now();
      }
      const bool out_of_time = config_.seconds > 0 && seconds_since(start_) >= config_.seconds;
      if (out_of_time || failed_ || config_.progress.cancelled())
        result_.complete = result_.points >= points && !failed_;
    }
    return finished();
  }

private:
  bool build(Tally& tally) {
    const Judge judge(subject_.parts(), 0, tally);
    return judge.answers([&] {
      judge.subject(subject_);
      tree_ = subject_.build(lights_, config_.tree_seed);
      topology_ = judge.tree(tree_->claim(), lights_);
    }) && topology_.has_value();
  }

  /// A tenth of a second or so, and the same whatever the machine.
  [[nodiscard]] std::uint64_t block_size() const {
    return std::clamp<std::uint64_t>(2'000'000 / topology_->size(), 8, 4096);
  }

  void check_materials() {
    const std::vector<Lobe> parts = parts_of(view_.scene());
    arena_.execute([&] {
      tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t i) {
        Judge(subject_.parts(), i, workers_.local().tally).lobe(parts[i]);
      });
    });
  }

  void check_block(std::uint64_t begin, std::uint64_t end) {
    arena_.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::uint64_t>(begin, end, 4),
          [&](const tbb::blocked_range<std::uint64_t>& range) {
            Worker& w = workers_.local();
            for (std::uint64_t i = range.begin(); i < range.end() && !failed_; ++i) check(i, w);
          },
          tbb::simple_partitioner());
    });
    result_.points = end;
    result_.pairs = end * topology_->size();
  }

  void check(std::uint64_t i, Worker& w) {
    const VisiblePoint p = random_point(view_, config_.seed, i);
    const Judge judge(subject_.parts(), i, w.tally);
    if (!judge.answers([&] { check_point_of(w, i, p); })) failed_ = true;
    const double rate = ray_rate(view_.scene(), *topology_);
    for (auto r = std::uint64_t(double(i) * rate); r < std::uint64_t(double(i + 1) * rate); ++r)
      judge.ray({subject_, view_, p, std::uint32_t(hashed(config_.seed + 1, r) % lights_.size()),
                 w.rays});
  }

  void check_point_of(Worker& w, std::uint64_t i, const VisiblePoint& p) {
    if (!w.tree) {
      const std::lock_guard lock(tree_mutex_);
      w.tree = tree_->for_another_thread();
      w.visible.resize(lights_.size());
      w.sweep.emplace(*topology_, lights_);
    }
    if (is_beside_light(i) && has(subject_.parts(), Part::bounds)) {
      check_beside_light(w, i);
      return;
    }
    if (is_of_block(i))
      Judge(subject_.parts(), i, w.tally)
          .block({*w.tree, subject_.parts()}, *topology_, lights_, block_at(view_, config_, i));
    if (i % points_per_full_check != 0 && sweep(w, i, p.point)) return;
    for (std::uint32_t j = 0; j < w.visible.size(); ++j) w.visible[j] = view_.sees(p, j) ? 1 : 0;
    w.truth.evaluate(*topology_, lights_, p.point, w.visible);
    check_point(config_, {i, p.point, w.visible, w.truth}, {*w.tree, subject_.parts()}, w.tally);
    if (const LightTree* tree = w.tree->library_tree();
        tree != nullptr && i % points_per_proof == 0)
      Judge(subject_.parts(), i, w.tally)
          .proofs(subject_, view_, *tree,
                  PixelSquare(view_, random_pixel(view_, config_.seed, i).pixel).seen,
                  rays_per_proof);
    if (i % points_per_excerpt == 0)
      check_case(subject_, excerpt_of(view_, config_, i), i, w.tally);
  }

  /// Bounds alone, many at a time; returns whether that can be done there.
  bool sweep(Worker& w, std::uint64_t i, const ShadingPoint& point) {
    if (!has(subject_.parts(), Part::bounds) || !w.sweep->supports(point.material())) return false;
    const auto start = Clock::now();
    w.sweep->check(*w.tree, point, i, w.tally);
    w.sweep_seconds += seconds_since(start);
    w.swept_pairs += topology_->size();
    return true;
  }

  void check_beside_light(Worker& w, std::uint64_t i) {
    const ShadingPoint point = view_beside_light_at(view_, *topology_, config_, i).point();
    if (sweep(w, i, point)) return;
    w.visible.assign(w.visible.size(), 1);
    w.truth.evaluate(*topology_, lights_, point, w.visible);
    const PointCase at{i, point, w.visible, w.truth};
    Judge(subject_.parts(), i, w.tally).clusters(PointAnswers({*w.tree, subject_.parts()}, at));
  }

  /// What the threads have counted goes into the result.
  void collect() {
    for (Worker& w : workers_) {
      result_.tally.merge(w.tally);
      result_.rays += w.rays.rays;
      result_.undecided_rays += w.rays.undecided;
      result_.swept_pairs += w.swept_pairs;
      result_.sweep_seconds += w.sweep_seconds;
      w.tally = {};
      w.rays = {};
      w.swept_pairs = 0;
      w.sweep_seconds = 0;
    }
    result_.seconds = seconds_before_ + seconds_since(start_);
  }

  CheckResult finished() {
    collect();
    return result_;
  }

  const SceneView& view_;
  const LightSet& lights_;
  const Subject& subject_;
  const CheckConfig& config_;
  CheckResult result_;
  double seconds_before_ = result_.seconds;
  Clock::time_point start_ = Clock::now(), saved_ = start_;
  std::unique_ptr<SubjectTree> tree_;
  std::optional<Topology> topology_;
  std::mutex tree_mutex_;            ///< copies of one tree are made one at a time
  std::atomic<bool> failed_ = false; ///< a subject that has failed once is asked no more
  tbb::enumerable_thread_specific<Worker> workers_;
  tbb::task_arena arena_;
};

} // namespace

CheckResult check(const SceneView& view, const Subject& subject, const CheckConfig& config,
                  const CheckResult& done) {
  if (view.scene().lights.empty())
    throw InputError(InputFault::missing, view.scene().name + ": no lights");
  return Campaign(view, subject, config, done).run();
}

} // namespace lightcuts::oracle
