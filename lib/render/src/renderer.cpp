// SPDX-License-Identifier: MIT
#include <lightcuts/render/renderer.h>

#include <atomic>
#include <chrono>

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/certified_error.h>
#include <lightcuts/paper_rules.h>
#include <lightcuts/stochastic_cut.h>
#include <lightcuts/sum_lights.h>
#include <lightcuts/unscaled_rules.h>

namespace lightcuts {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Lit {
  glm::vec3 radiance{0}, certified_error{0};
  float cut_size = 0, shadow_rays = 0;
  CutEnd end = CutEnd::converged;
};

Lit light_by_sum(const SceneView& view, const VisiblePoint& p) {
  const LightSet& lights = view.scene().lights;
  const LightSum sum =
      sum_lights(lights, p.point, [&](std::uint32_t light) { return view.sees(p, light); });
  Lit lit;
  for (int c = 0; c < 3; ++c) {
    lit.radiance[c] = to_float(sum.radiance[c]);
    lit.certified_error[c] = certified_error(sum.radiance[c], 0);
  }
  lit.cut_size = static_cast<float>(lights.size());
  lit.shadow_rays = view.may_occlude() ? static_cast<float>(sum.shadow_rays) : 0;
  return lit;
}

Lit lit_by(const Cut& cut) {
  return {cut.radiance, cut.certified_error, static_cast<float>(cut.clusters.size()),
          static_cast<float>(cut.shadow_rays), cut.end};
}

Rendering blank(glm::uvec2 size) {
  const std::size_t pixels = std::size_t(size.x) * size.y;
  Rendering r;
  r.size = size;
  for (auto* v : {&r.radiance, &r.certified_error, &r.emission}) v->resize(pixels, glm::vec3(0));
  for (auto* v : {&r.cut_size, &r.shadow_rays, &r.microseconds}) v->resize(pixels, 0);
  r.end.resize(pixels, CutEnd::converged);
  return r;
}

void store(Rendering& r, std::size_t i, const Lit& lit, const glm::vec3& emission) {
  r.radiance[i] = lit.radiance;
  r.certified_error[i] = lit.certified_error;
  r.emission[i] = emission;
  r.cut_size[i] = lit.cut_size;
  r.shadow_rays[i] = lit.shadow_rays;
  r.end[i] = lit.end;
}

/// Renders with light(p, pixel, state) for each visible point, state being one per thread.
template <class State, class Light>
Rendering render_tiles(const SceneView& view, const RenderConfig& config, State&& make_state,
                       const Light& light) {
  const glm::uvec2 size = view.size();
  Rendering result = blank(size);
  std::atomic<std::uint64_t> surface_pixels = 0;
  std::atomic<std::uint64_t> pixels_done = 0;
  tbb::enumerable_thread_specific<decltype(make_state())> states(make_state);

  const auto light_tile = [&](const tbb::blocked_range2d<unsigned>& tile) {
    auto& state = states.local();
    std::uint64_t seen = 0;
    for (unsigned y = tile.rows().begin(); y < tile.rows().end(); ++y)
      for (unsigned x = tile.cols().begin(); x < tile.cols().end(); ++x) {
        const auto start = Clock::now();
        const std::size_t i = std::size_t(y) * size.x + x;
        const auto p = view.at({x, y});
        if (!p) continue;
        ++seen;
        store(result, i, light(*p, i, state), p->emission);
        result.microseconds[i] = static_cast<float>(1e6 * seconds_since(start));
      }
    surface_pixels += seen;
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
  result.seconds = seconds_since(start);
  result.surface_pixels = surface_pixels;
  return result;
}

template <template <class> class Rules>
Rendering render_by_cuts(const SceneView& view, const LightTree& tree, const RenderConfig& config) {
  CutConfig cut = config.cut;
  cut.unoccluded = config.specialise && !view.may_occlude();
  const auto render_with = [&](auto features) {
    using Selector = BasicCutSelector<Rules<decltype(features)>>;
    return render_tiles(
        view, config, [&] { return Selector(tree, cut); },
        [&](const VisiblePoint& p, std::size_t /*pixel*/, Selector& select) {
          return lit_by(
              select(p.point, [&](std::uint32_t light) { return view.casts_to(p, light); }));
        });
  };
  if (!config.specialise) return render_with(AnyFeatures());
  return with_features(tree.lights(), view.may_occlude(), render_with);
}

template <template <class> class Importance>
Rendering render_by_samples(const SceneView& view, const LightTree& tree,
                            const RenderConfig& config) {
  CutConfig cut = config.cut;
  cut.unoccluded = config.specialise && !view.may_occlude();
  const auto render_with = [&](auto features) {
    using Features = decltype(features);
    using Selector =
        BasicStochasticCutSelector<BasicLightcutsRules<Features>, Importance<Features>>;
    return render_tiles(
        view, config, [&] { return Selector(tree, cut, config.seed); },
        [&](const VisiblePoint& p, std::size_t pixel, Selector& select) {
          return lit_by(
              select(p.point, pixel, [&](std::uint32_t light) { return view.casts_to(p, light); }));
        });
  };
  if (!config.specialise) return render_with(AnyFeatures());
  // Without occlusion, too: what that leaves out plays no part here, but for error bounds that
  // take time.
  return with_features(tree.lights(), true, render_with);
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

Rendering render(const SceneView& view, const LightTree& tree, const RenderConfig& config) {
  switch (config.method) {
  case Method::paper:
    return render_by_cuts<BasicPaperRules>(view, tree, config);
  case Method::unscaled:
    return render_by_cuts<BasicUnscaledRules>(view, tree, config);
  case Method::stochastic_intensity:
    return render_by_samples<AlikeForAll>(view, tree, config);
  case Method::stochastic:
    return render_by_samples<HierarchicalImportance>(view, tree, config);
  case Method::lightcuts:
    if (config.use_tree) return render_by_cuts<BasicLightcutsRules>(view, tree, config);
    break;
  case Method::reference:
    break;
  }
  return render_tiles(
      view, config, [] { return 0; },
      [&](const VisiblePoint& p, std::size_t /*pixel*/, int /*no state*/) {
        return light_by_sum(view, p);
      });
}

} // namespace lightcuts
