// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/renderer.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <memory>

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/render/view/pixel_square.h>

namespace lightcuts {
namespace {

void store(Rendering& r, std::size_t i, const PixelResult& result, const glm::vec3& emission) {
  r.radiance[i] = result.radiance;
  r.certified_error[i] = result.certified_error;
  r.emission[i] = emission;
  r.cut_size[i] = result.cut_size;
  r.shadow_rays[i] = result.shadow_rays;
  r.end[i] = result.end;
}

/// Tiles are what threads take in turn; whole squares.
constexpr unsigned tile_side = 2 * PixelSquare::side;

using Wanted = std::function<bool(glm::uvec2)>;

/// What of which picture is to be rendered.
struct Task {
  Rendering& picture;
  const SceneView& view;
  const LightTree& tree;
  const RenderConfig& config;
  const Wanted& wanted; ///< empty: all pixels

  [[nodiscard]] bool wants(glm::uvec2 pixel) const { return !wanted || wanted(pixel); }
};

bool wants_any(const Task& task, const PixelRect& rect) {
  for (unsigned y = rect.lo.y; y < rect.hi.y; ++y)
    for (unsigned x = rect.lo.x; x < rect.hi.x; ++x)
      if (task.wants({x, y})) return true;
  return false;
}

/// Of a square's pixels, those that see no surface.
void store_beyond(const Task& task, const PixelRect& rect, const PixelSquare& square) {
  for (unsigned y = rect.lo.y; y < rect.hi.y; ++y)
    for (unsigned x = rect.lo.x; x < rect.hi.x; ++x)
      if (const glm::uvec2 pixel(x, y);
          task.wants(pixel) && std::ranges::find(square.pixels, pixel) == square.pixels.end())
        task.picture.emission[std::size_t(y) * task.view.size().x + x] = task.view.beyond(pixel);
}

/// What the task's method lights with; a cut's kernel may know whether anything occludes.
LighterConfig lighter_config(const Task& task) {
  const RenderConfig& config = task.config;
  LighterConfig lighter{.lights = task.view.scene().lights,
                        .tree = task.tree,
                        .cut = config.cut,
                        .kinds = config.specialise ? task.tree.lights().kinds() : all_light_kinds,
                        .may_occlude = task.view.may_occlude(),
                        .use_tree = config.use_tree,
                        .seed = config.seed};
  lighter.cut.unoccluded = config.specialise && !task.view.may_occlude();
  if (config.rules) lighter.rules = *config.rules;
  return lighter;
}

/// Renders in tiles, with a lighter for each thread.
void render_tiles(const Task& task) {
  const glm::uvec2 size = task.view.size();
  const RenderConfig& config = task.config;
  std::atomic<std::uint64_t> surface_pixels = 0;
  std::atomic<std::uint64_t> pixels_done = 0;
  tbb::enumerable_thread_specific<std::unique_ptr<PointLighter>> lighters(
      [&task] { return task.config.method->lighter(lighter_config(task)); });

  const auto light_pixel = [&](glm::uvec2 pixel, PointLighter& lighter) {
    const auto start = Clock::now();
    const std::size_t i = std::size_t(pixel.y) * size.x + pixel.x;
    const auto p = task.view.at(pixel);
    if (!p) {
      task.picture.emission[i] = task.view.beyond(pixel);
      return;
    }
    ++surface_pixels;
    const auto visible = [&](std::uint32_t light) { return task.view.casts_to(*p, light); };
    store(task.picture, i, lighter.light(p->point, i, visible), p->emission);
    task.picture.microseconds[i] = static_cast<float>(1e6 * seconds_since(start));
  };
  /// Whether all pixels of the row that are wanted have been rendered.
  const auto light_row = [&](unsigned y, unsigned begin, unsigned end, PointLighter& lighter) {
    bool any = false;
    for (unsigned x = begin; x < end; ++x) {
      if (!task.wants({x, y})) continue;
      if (config.progress.cancelled()) return false;
      light_pixel({x, y}, lighter);
      any = true;
    }
    if (any && config.done) config.done({{begin, y}, {end, y + 1}});
    return true;
  };
  /// Neighbours together. Whether all that are wanted have been rendered.
  const auto light_square = [&](const PixelRect& rect, PointLighter& lighter) {
    if (!wants_any(task, rect)) return true;
    if (config.progress.cancelled()) return false;
    const auto start = Clock::now();
    const PixelSquare square(task.view, rect.lo);
    const std::vector<PixelResult> results = light(square, task.view, lighter);
    const double each =
        1e6 * seconds_since(start) / double(std::max<std::size_t>(1, results.size()));
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (!task.wants(square.pixels[k])) continue;
      const std::size_t i = std::size_t(square.pixels[k].y) * size.x + square.pixels[k].x;
      store(task.picture, i, results[k], square.seen[k].emission);
      task.picture.microseconds[i] = static_cast<float>(each);
      ++surface_pixels;
    }
    if (!task.view.scene().backdrops.empty()) store_beyond(task, rect, square);
    if (config.done) config.done(rect);
    return true;
  };
  const auto light_squares = [&](const PixelRect& tile, PointLighter& lighter) {
    for (unsigned y = tile.lo.y; y < tile.hi.y; y += PixelSquare::side)
      for (unsigned x = tile.lo.x; x < tile.hi.x; x += PixelSquare::side)
        if (!light_square({{x, y},
                           {std::min(x + PixelSquare::side, tile.hi.x),
                            std::min(y + PixelSquare::side, tile.hi.y)}},
                          lighter))
          return false;
    return true;
  };
  const auto light_rows = [&](const PixelRect& tile, PointLighter& lighter) {
    for (unsigned y = tile.lo.y; y < tile.hi.y; ++y)
      if (!light_row(y, tile.lo.x, tile.hi.x, lighter)) return false;
    return true;
  };
  const auto light_tile = [&](const tbb::blocked_range2d<unsigned>& tile) {
    PointLighter& lighter = *lighters.local();
    const PixelRect rect{{tile.cols().begin() * tile_side, tile.rows().begin() * tile_side},
                         {std::min(tile.cols().end() * tile_side, size.x),
                          std::min(tile.rows().end() * tile_side, size.y)}};
    if (!(lighter.shares() ? light_squares(rect, lighter) : light_rows(rect, lighter))) return;
    const auto done = pixels_done += std::uint64_t(rect.hi.x - rect.lo.x) * (rect.hi.y - rect.lo.y);
    config.progress.report(double(done) / (double(size.x) * size.y));
  };

  const auto start = Clock::now();
  tbb::task_arena arena(config.threads == 0 ? tbb::task_arena::automatic
                                            : static_cast<int>(config.threads));
  arena.execute([&] {
    const auto tiles = [](unsigned pixels) { return (pixels + tile_side - 1) / tile_side; };
    tbb::parallel_for(tbb::blocked_range2d<unsigned>(0, tiles(size.y), 1, 0, tiles(size.x), 1),
                      light_tile, tbb::simple_partitioner());
  });
  task.picture.seconds += seconds_since(start);
  task.picture.surface_pixels += surface_pixels;
}

} // namespace

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
  render_tiles({picture, view, tree, config, wanted});
}

Rendering render(const SceneView& view, const LightTree& tree, const RenderConfig& config) {
  Rendering picture = blank_rendering(view.size());
  render_into(picture, view, tree, config, {});
  return picture;
}

} // namespace lightcuts
