// SPDX-License-Identifier: MIT
#include <oracle/report/measure.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/core/methods/paper.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/cases/random_pixels.h>
#include <oracle/numbers/same_digits.h>
#include <oracle/properties/point_case.h>
#include <oracle/report/image_error.h>
#include <oracle/subjects/library_subject.h>
#include <oracle/truth/clairvoyant.h>

namespace lightcuts::oracle {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One line of the table on its way. Where lightcuts leaves the tree out it is the reference: the
/// picture and the times are those of the first row.
struct Row {
  RenderConfig config;
  std::vector<double> seconds;
  Rendering picture;
};

std::vector<Row> rows_to_run(const SceneView& view, const LightTree& tree,
                             const MeasureConfig& config, float black_level) {
  std::vector<Row> rows;
  // The reference comes first: everything is compared with it, asked for or not.
  const CutConfig exact{0, config.max_cut, black_level};
  rows.push_back({{.method = methods::reference, .cut = exact, .threads = config.threads}, {}, {}});
  for (const Method method : config.methods)
    for (const float threshold : config.thresholds) {
      if (method == methods::reference) break;
      const CutConfig cut{threshold, config.max_cut, black_level};
      const bool use_tree =
          method != methods::lightcuts || find_scene_features(view, tree, cut).tree;
      rows.push_back({{.method = method,
                       .cut = cut,
                       .use_tree = use_tree,
                       .threads = config.threads,
                       .seed = config.seed},
                      {},
                      {}});
    }
  return rows;
}

bool leaves_tree_out(const Row& row) {
  return row.config.method == methods::lightcuts && !row.config.use_tree;
}

void run_in_turn(const SceneView& view, const LightTree& tree, const MeasureConfig& config,
                 std::vector<Row>& rows) {
  const double total = double(rows.size()) * config.repeats;
  double done = 0;
  for (int repeat = 0; repeat < config.repeats; ++repeat)
    for (Row& row : rows) {
      ++done;
      if (leaves_tree_out(row)) continue;
      row.config.progress = config.progress.part((done - 1) / total, 1 / total);
      Rendering picture = render(view, tree, row.config);
      config.progress.leave_if_cancelled();
      row.seconds.push_back(picture.seconds);
      row.picture = std::move(picture);
    }
  for (Row& row : rows)
    if (leaves_tree_out(row)) {
      row.seconds = rows.front().seconds;
      row.picture = rows.front().picture;
    }
}

double mean(const std::vector<float>& values, std::uint64_t count) {
  double sum = 0;
  for (const float v : values) sum += v;
  return count == 0 ? 0 : sum / double(count);
}

/// A row whose cuts are compared with the clairvoyant ones.
struct SampledRow {
  std::unique_ptr<SubjectTree> subject;
  CutConfig cut;
  double clairvoyant = 0, actual = 0; ///< mean cut sizes
};

/// The tree as that method uses it, which draws nothing: drawn estimates have no clairvoyant cut.
std::unique_ptr<SubjectTree> tree_of(Method method, const LightTree& tree) {
  return std::make_unique<LibraryTree>(tree, library_kernel(all_light_kinds, method->rules));
}

/// Whether a row has cuts that do not draw, which is what can be compared.
bool has_clairvoyant_cut(const Row& row) {
  return row.config.method->cuts && !row.config.method->draws;
}

/// Of those rows that have a clairvoyant cut, in their order: cut sizes over random points, whose
/// truth is found once for all rows.
std::vector<SampledRow> sample_sizes(const SceneView& view, const LightTree& tree,
                                     const std::vector<Row>& rows, const MeasureConfig& config) {
  std::vector<SampledRow> sampled;
  for (const Row& row : rows) {
    if (!has_clairvoyant_cut(row)) continue;
    SampledRow& last = sampled.emplace_back();
    last.subject = tree_of(row.config.method, tree);
    last.cut = row.config.cut;
  }
  if (sampled.empty()) return sampled;
  const LightSet& scene_lights = view.scene().lights;
  const std::size_t lights = scene_lights.size();
  const std::size_t points = std::clamp<std::size_t>(2'000'000 / lights, 16, 256);
  const Topology topology = *read_topology(claim_of(tree), lights).topology;
  Truth truth;
  std::vector<char> visible(lights);
  const auto seen = [&](std::uint32_t j) { return visible[j] != 0; };
  for (std::size_t i = 0; i < points; ++i) {
    config.progress.leave_if_cancelled();
    const VisiblePoint p = random_point(view, config.seed, i);
    for (std::uint32_t j = 0; j < lights; ++j) visible[j] = view.sees(p, j) ? 1 : 0;
    truth.evaluate(topology, scene_lights, p.point, visible);
    for (SampledRow& row : sampled) {
      const Judged judged{*row.subject,
                          only(Part::bounds) | only(Part::estimates) | only(Part::cuts)};
      const PointCase at{i, p.point, visible, truth};
      const auto estimate = [&](std::uint32_t node) { return seen_estimate(judged, node, at); };
      const std::size_t clairvoyant =
          clairvoyant_cut_size(truth, estimate, row.cut.threshold, row.cut.black_level);
      row.clairvoyant += double(clairvoyant) / double(points);
      row.actual +=
          double(row.subject->select(p.point, row.cut, seen).clusters.size()) / double(points);
    }
  }
  return sampled;
}

Run summary(const Row& row, const Row& reference, double build_seconds) {
  const Rendering& p = row.picture;
  const CutConfig& cut = row.config.cut;
  const bool exact = row.config.method == methods::reference;
  const ImageError e = compare(p, reference.picture, cut.threshold, cut.black_level);
  Run run;
  run.method = row.config.method->name;
  run.threshold = same_digits(cut.threshold);
  run.build_seconds = exact || !row.config.use_tree ? 0 : build_seconds;
  run.render_seconds = median(row.seconds);
  run.mean_cut_size = mean(p.cut_size, p.surface_pixels);
  run.shadow_rays_per_pixel = mean(p.shadow_rays, p.surface_pixels);
  run.rel_rmse = e.rel_rmse;
  run.mrse = e.mrse;
  run.mean_relative_error = e.mean;
  run.max_relative_error = e.max;
  run.mean_certified_error = e.mean_certified;
  run.pixels_over_threshold = e.pixels_over_threshold;
  run.dark_pixels =
      static_cast<std::uint64_t>(std::count(p.end.begin(), p.end.end(), CutEnd::black_level));
  run.size_limited_pixels =
      static_cast<std::uint64_t>(std::count(p.end.begin(), p.end.end(), CutEnd::max_size));
  run.speedup_over_reference = median(reference.seconds) / run.render_seconds;
  if (e.rel_rmse > 0) run.efficiency = 1 / (e.rel_rmse * e.rel_rmse * run.render_seconds);
  return run;
}

/// The row nearest to the scene's threshold, of lightcuts if there is one, of the last of the other
/// methods else.
const Row& row_to_show(const std::vector<Row>& rows, float threshold) {
  const auto rank = [threshold](const Row& row) {
    // As all_methods has them, the best last.
    const auto* place =
        std::find(std::begin(all_methods), std::end(all_methods), row.config.method);
    return std::pair(std::end(all_methods) - place, std::abs(row.config.cut.threshold - threshold));
  };
  return *std::min_element(rows.begin(), rows.end(),
                           [&](const Row& a, const Row& b) { return rank(a) < rank(b); });
}

Report facts(const SceneView& view, const MeasureConfig& config) {
  Report report;
  report.scene = view.scene().name;
  report.seed = config.seed;
  report.builder = name_of(config.builder);
  report.lights = view.scene().lights.size();
  report.triangles = view.scene().mesh.triangles.size();
  report.size = view.size();
  report.threads =
      config.threads == 0 ? unsigned(tbb::this_task_arena::max_concurrency()) : config.threads;
  report.repeats = config.repeats;
  return report;
}

} // namespace

void describe_features(const SceneView& view, const SceneFeatures& features, float threshold,
                       std::vector<std::string>& needed, std::vector<std::string>& left_out) {
  const auto say = [&](bool is_needed, const std::string& text) {
    (is_needed ? needed : left_out).push_back(text);
  };
  std::vector<std::string> kinds[2]; // those there are not, and those there are
  for (int k = 0; k < light_kind_count; ++k)
    kinds[(features.kinds & only(LightKind(k))) != 0].emplace_back(name_of(LightKind(k)));
  for (const bool there : {true, false})
    if (!kinds[there].empty())
      say(there, fmt::format("{} lights{}", fmt::join(kinds[there], ", "),
                             there ? "" : ": there are none"));
  say(features.clamp, features.clamp ? fmt::format("clamp: distances count as at least {:g} m",
                                                   view.scene().lights.min_distance())
                                     : "clamp: distances are taken as they are");
  say(features.specular, features.specular ? "specular bound: some surfaces are glossy"
                                           : "specular bound: all surfaces are diffuse");
  say(features.occlusion, features.occlusion
                              ? "shadow rays: something may stand before a light"
                              : "shadow rays: the scene is a convex room, nothing occludes");
  if (!features.sees_surface) {
    say(false, "light tree: the camera sees no surface");
    return;
  }
  say(features.tree,
      fmt::format("light tree: at threshold {:g} % cuts have {:.1f} of {} lights and are expected "
                  "to take {:.2f} times as long as all lights",
                  100 * double(threshold), features.pilot_cut_size, view.scene().lights.size(),
                  features.pilot_cost_of_cuts / features.pilot_cost_of_sums));
}

KernelSaving measure_kernels(const Scene& scene, const LightTree& tree,
                             const SceneFeatures& features, const CutConfig& config) {
  Scene small = scene;
  const std::uint32_t side = std::max(scene.image_size.x, scene.image_size.y);
  small.image_size = glm::max(glm::uvec2(1), scene.image_size * 64U / std::max(64U, side));
  const SceneView view(small);
  RenderConfig own{.cut = config, .use_tree = features.tree, .threads = 1};
  own.cut.black_level = features.black_level;
  RenderConfig general = own;
  general.use_tree = true;
  general.specialise = false;
  std::vector<double> own_seconds, general_seconds;
  for (int run = 0; run < 5; ++run) {
    own_seconds.push_back(render(view, tree, own).seconds);
    general_seconds.push_back(render(view, tree, general).seconds);
  }
  return {median(general_seconds), median(own_seconds)};
}

Measurement measure(const SceneView& view, const MeasureConfig& config) {
  const auto start = Clock::now();
  const LightTree tree = build(view.scene().lights, {config.seed, config.builder});
  const double build_seconds = seconds_since(start);
  if (tree.empty()) throw InputError(InputFault::missing, view.scene().name + ": no lights");

  Measurement m;
  m.report = facts(view, config);
  const float threshold = default_threshold(view);
  const float black_level =
      find_scene_features(view, tree, {threshold, config.max_cut, 0}).black_level;
  std::vector<Row> rows = rows_to_run(view, tree, config, black_level);
  run_in_turn(view, tree, config, rows);

  const std::vector<SampledRow> sampled = sample_sizes(view, tree, rows, config);
  auto sizes = sampled.begin();
  const bool shows_reference = std::find(config.methods.begin(), config.methods.end(),
                                         methods::reference) != config.methods.end();
  for (const Row& row : rows) {
    Run run = summary(row, rows.front(), build_seconds);
    if (has_clairvoyant_cut(row)) {
      run.optimal_cut_size = sizes->clairvoyant;
      run.cut_efficiency = sizes->clairvoyant /
                           (leaves_tree_out(row) ? double(tree.lights().size()) : sizes->actual);
      ++sizes;
    }
    if (row.config.method != methods::reference || shows_reference) m.report.runs.push_back(run);
  }
  const Row& shown = row_to_show(rows, threshold);
  m.shown = shown.picture;
  m.shown_threshold = shown.config.cut.threshold;
  m.reference = rows.front().picture;
  m.features = find_scene_features(view, tree, {m.shown_threshold, config.max_cut, 0});
  m.report.black_level = black_level;
  m.report.surface_pixels = m.reference.surface_pixels;
  for (std::size_t i = 0; i < m.shown.cut_size.size(); ++i)
    if (m.shown.cut_size[i] > 0) m.report.cut_sizes.push_back(m.shown.cut_size[i]);
  describe_features(view, m.features, m.shown_threshold, m.report.needs, m.report.left_out);
  return m;
}

} // namespace lightcuts::oracle
