// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/renderer.h>

#include <atomic>
#include <cassert>
#include <chrono>

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/cut/stochastic_cut.h>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/methods/no_specular_bound_rules.h>
#include <lightcuts/core/methods/paper_rules.h>
#include <lightcuts/core/methods/unscaled_rules.h>

namespace lightcuts {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct PixelResult {
  glm::vec3 radiance{0}, certified_error{0};
  float cut_size = 0, shadow_rays = 0;
  CutEnd end = CutEnd::converged;
};

PixelResult light_by_sum(const SceneView& view, const VisiblePoint& p) {
  const LightSet& lights = view.scene().lights;
  const LightSum sum =
      sum_lights(lights, p.point, [&](std::uint32_t light) { return view.sees(p, light); });
  PixelResult result;
  for (int c = 0; c < 3; ++c) {
    result.radiance[c] = to_float(sum.radiance[c]);
    result.certified_error[c] = certified_error(sum.radiance[c], 0);
  }
  result.cut_size = static_cast<float>(lights.size());
  result.shadow_rays = view.may_occlude() ? static_cast<float>(sum.shadow_rays) : 0;
  return result;
}

PixelResult lit_by(const Cut& cut) {
  return {cut.radiance, cut.certified_error, static_cast<float>(cut.clusters.size()),
          static_cast<float>(cut.shadow_rays), cut.end};
}

void store(Rendering& r, std::size_t i, const PixelResult& result, const glm::vec3& emission) {
  r.radiance[i] = result.radiance;
  r.certified_error[i] = result.certified_error;
  r.emission[i] = emission;
  r.cut_size[i] = result.cut_size;
  r.shadow_rays[i] = result.shadow_rays;
  r.end[i] = result.end;
}

using Wanted = std::function<bool(glm::uvec2)>;

/// What of which picture is to be rendered.
struct Task {
  Rendering& picture;
  const SceneView& view;
  const LightTree& tree;
  const RenderConfig& config;
  const Wanted& wanted; ///< empty: all pixels

  [[nodiscard]] bool wants(glm::uvec2 pixel) const { return !wanted || wanted(pixel); }
  [[nodiscard]] bool cancelled() const { return config.cancelled && config.cancelled(); }
};

/// Renders with light(p, pixel, state) for each visible point, state being one per thread.
template <class State, class Light>
void render_tiles(const Task& task, State&& make_state, const Light& light) {
  const glm::uvec2 size = task.view.size();
  const RenderConfig& config = task.config;
  std::atomic<std::uint64_t> surface_pixels = 0;
  std::atomic<std::uint64_t> pixels_done = 0;
  tbb::enumerable_thread_specific<decltype(make_state())> states(make_state);

  const auto light_pixel = [&](glm::uvec2 pixel, auto& state) {
    const auto start = Clock::now();
    const std::size_t i = std::size_t(pixel.y) * size.x + pixel.x;
    const auto p = task.view.at(pixel);
    if (!p) return;
    ++surface_pixels;
    store(task.picture, i, light(*p, i, state), p->emission);
    task.picture.microseconds[i] = static_cast<float>(1e6 * seconds_since(start));
  };
  /// Whether all pixels of the row that are wanted have been rendered.
  const auto light_row = [&](unsigned y, unsigned begin, unsigned end, auto& state) {
    bool any = false;
    for (unsigned x = begin; x < end; ++x) {
      if (!task.wants({x, y})) continue;
      if (task.cancelled()) return false;
      light_pixel({x, y}, state);
      any = true;
    }
    if (any && config.done) config.done({{begin, y}, {end, y + 1}});
    return true;
  };
  const auto light_tile = [&](const tbb::blocked_range2d<unsigned>& tile) {
    auto& state = states.local();
    for (unsigned y = tile.rows().begin(); y < tile.rows().end(); ++y)
      if (!light_row(y, tile.cols().begin(), tile.cols().end(), state)) return;
    const auto done = pixels_done += tile.rows().size() * tile.cols().size();
    if (config.progress) config.progress(double(done) / (double(size.x) * size.y));
  };

  const auto start = Clock::now();
  tbb::task_arena arena(config.threads == 0 ? tbb::task_arena::automatic
                                            : static_cast<int>(config.threads));
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range2d<unsigned>(0, size.y, 16, 0, size.x, 16), light_tile,
                      tbb::simple_partitioner());
  });
  task.picture.seconds += seconds_since(start);
  task.picture.surface_pixels += surface_pixels;
}

/// How a view's cuts are configured for a kernel that knows whether anything occludes.
CutConfig cut_config(const Task& task) {
  CutConfig cut = task.config.cut;
  cut.unoccluded = task.config.specialise && !task.view.may_occlude();
  return cut;
}

template <class Selector>
void render_with(const Task& task, const Selector& prototype) {
  render_tiles(
      task, [&] { return prototype; },
      [&](const VisiblePoint& p, std::size_t /*pixel*/, Selector& select) {
        return lit_by(
            select(p.point, [&](std::uint32_t light) { return task.view.casts_to(p, light); }));
      });
}

template <template <class> class Rules>
void render_by_cuts(const Task& task) {
  const auto render_for = [&](auto features) {
    render_with(task, BasicCutSelector<Rules<decltype(features)>>(task.tree, cut_config(task)));
  };
  if (!task.config.specialise) return render_for(AnyFeatures());
  with_features(task.tree.lights(), task.view.may_occlude(), render_for);
}

template <template <class> class Importance>
void render_by_samples(const Task& task) {
  const auto render_for = [&](auto features) {
    using Features = decltype(features);
    using Selector =
        BasicStochasticCutSelector<BasicLightcutsRules<Features>, Importance<Features>>;
    render_tiles(
        task, [&] { return Selector(task.tree, cut_config(task), task.config.seed); },
        [&](const VisiblePoint& p, std::size_t pixel, Selector& select) {
          return lit_by(select(p.point, pixel,
                               [&](std::uint32_t light) { return task.view.casts_to(p, light); }));
        });
  };
  if (!task.config.specialise) return render_for(AnyFeatures());
  // Without occlusion, too: what that leaves out plays no part here, but for error bounds that
  // take time.
  with_features(task.tree.lights(), true, render_for);
}

void render_by_sums(const Task& task) {
  render_tiles(
      task, [] { return 0; },
      [&](const VisiblePoint& p, std::size_t /*pixel*/, int /*no state*/) {
        return light_by_sum(task.view, p);
      });
}

void render_lightcuts(const Task& task) {
  if (!task.config.use_tree) return render_by_sums(task);
  if (!task.config.rules) return render_by_cuts<BasicLightcutsRules>(task);
  render_with(task, BasicCutSelector<ChosenRules>(task.tree, cut_config(task), *task.config.rules));
}

template <class>
using AlikeForAll = IntensityImportance;

} // namespace

const char* name_of(Method method) {
  switch (method) {
  case Method::reference:
    return "reference";
  case Method::paper:
    return "paper";
  case Method::unscaled:
    return "unscaled";
  case Method::stochastic_intensity:
    return "stochastic-intensity";
  case Method::stochastic:
    return "stochastic";
  case Method::no_specular_bound:
    return "no-specular-bound";
  case Method::lightcuts:
    return "lightcuts";
  }
  return "";
}

std::optional<Method> method_named(std::string_view name) {
  for (const Method m : all_methods)
    if (name == name_of(m)) return m;
  return std::nullopt;
}

Rendering blank_rendering(glm::uvec2 size) {
  const std::size_t pixels = std::size_t(size.x) * size.y;
  Rendering r;
  r.size = size;
  for (auto* v : {&r.radiance, &r.certified_error, &r.emission}) v->resize(pixels, glm::vec3(0));
  for (auto* v : {&r.cut_size, &r.shadow_rays, &r.microseconds}) v->resize(pixels, 0);
  r.end.resize(pixels, CutEnd::converged);
  return r;
}

void render_into(Rendering& picture, const SceneView& view, const LightTree& tree,
                 const RenderConfig& config, const std::function<bool(glm::uvec2)>& wanted) {
  assert(picture.size == view.size());
  const Task task{picture, view, tree, config, wanted};
  switch (config.method) {
  case Method::reference:
    return render_by_sums(task);
  case Method::paper:
    return render_by_cuts<BasicPaperRules>(task);
  case Method::unscaled:
    return render_by_cuts<BasicUnscaledRules>(task);
  case Method::stochastic_intensity:
    return render_by_samples<AlikeForAll>(task);
  case Method::stochastic:
    return render_by_samples<HierarchicalImportance>(task);
  case Method::no_specular_bound:
    return render_by_cuts<BasicNoSpecularBoundRules>(task);
  case Method::lightcuts:
    return render_lightcuts(task);
  }
}

Rendering render(const SceneView& view, const LightTree& tree, const RenderConfig& config) {
  Rendering picture = blank_rendering(view.size());
  render_into(picture, view, tree, config, {});
  return picture;
}

} // namespace lightcuts
