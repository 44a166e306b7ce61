// SPDX-License-Identifier: MIT
// Whether the squares that pixels are lit in show in a picture.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/view/method_choice.h>
#include <lightcuts/render/view/pixel_square.h>
#include <lightcuts/render/view/renderer.h>

namespace lightcuts {
namespace {

constexpr unsigned side = PixelSquare::side;

double sum(const glm::vec3& v) { return double(v.x) + v.y + v.z; }

struct Errors {
  glm::uvec2 size;
  std::vector<double> relative; ///< signed, row by row; NaN where nothing is lit

  Errors(const Rendering& picture, const Rendering& exact)
      : size(picture.size), relative(picture.radiance.size()) {
    for (std::size_t i = 0; i < relative.size(); ++i)
      relative[i] = sum(picture.radiance[i]) / sum(exact.radiance[i]) - 1;
  }
  [[nodiscard]] double at(unsigned x, unsigned y) const {
    return relative[std::size_t(y) * size.x + x];
  }
};

/// Of means over squares of a grid that is shifted.
struct Mean {
  double sum = 0, squares = 0, count = 0;
  void add(double v) {
    sum += v;
    squares += v * v;
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] double deviation() const {
    return std::sqrt((squares / count - mean() * mean()) / (count - 1));
  }
};

/// Over squares of which all pixels and their right neighbours are lit.
struct BlockEdges {
  Mean all;   ///< absolute errors
  Mean error; ///< of a square: mean on its rim less mean inside
  Mean step;  ///< of a square: mean change of the error to the right neighbour, across the edge
              ///< less inside

  explicit BlockEdges(const Errors& e) {
    for (unsigned y = 0; y + side <= e.size.y; y += side)
      for (unsigned x = 0; x + side < e.size.x; x += side) add_square(e, x, y);
  }

private:
  void add_square(const Errors& e, unsigned left, unsigned top) {
    Mean rim, inside, across, within, whole;
    for (unsigned y = 0; y < side; ++y)
      for (unsigned x = 0; x < side; ++x) {
        const double here = e.at(left + x, top + y), next = e.at(left + x + 1, top + y);
        const bool on_rim = x == 0 || y == 0 || x + 1 == side || y + 1 == side;
        (on_rim ? rim : inside).add(std::abs(here));
        (x + 1 == side ? across : within).add(std::abs(here - next));
        whole.add(std::abs(here));
      }
    if (!std::isfinite(across.sum + within.sum)) return;
    all.add(whole.mean());
    error.add(rim.mean() - inside.mean());
    step.add(across.mean() - within.mean());
  }
};

/// A scene by shared cuts at their default threshold, and without error.
struct Pictures {
  Rendering shared, exact;

  explicit Pictures(const std::string& spec) {
    Scene scene = make_builtin(spec);
    scene.image_size = {160, 120};
    const SceneView view(scene);
    const LightTree tree = build(scene.lights);
    RenderConfig config;
    config.method = methods::reference;
    exact = render(view, tree, config);
    config.method = methods::block_cuts;
    config.cut = {default_block_threshold(view), default_max_cut, 0};
    shared = render(view, tree, config);
  }
};

// A change by less than half a percent is not seen (about one percent is, at best, between large
// fields). Neighbours that share know less at the rim of a block, where they lie on one side only.
// Five deviations of the mean over squares: a false alarm in 3 * 10^6 tests.
constexpr double deviations = 5, visible_step = 0.005, more_on_the_rim = 0.4;

TEST(BlockEdges, DoNotShow) {
  for (const char* spec :
       {"cloud?lights=2000", "cloud?lights=2000&blocks=0", "cloud?lights=2000&material=glossy",
        "cloud?lights=2000&kind=oriented", "desk", "bedroom"}) {
    const Pictures pictures(spec);
    const BlockEdges edges(Errors(pictures.shared, pictures.exact));
    EXPECT_LT(edges.step.mean() - deviations * edges.step.deviation(), visible_step) << spec;
    EXPECT_LT(edges.error.mean() - deviations * edges.error.deviation(),
              more_on_the_rim * edges.all.mean())
        << spec;
  }
}

TEST(BlockEdges, ShowWhereSquaresAreBrighterByTwoPercent) {
  Pictures pictures("cloud?lights=2000&blocks=0");
  const glm::uvec2 size = pictures.shared.size;
  for (unsigned y = 0; y < size.y; ++y)
    for (unsigned x = 0; x < size.x; ++x)
      if ((x / side + y / side) % 2 == 0)
        pictures.shared.radiance[std::size_t(y) * size.x + x] *= 1.02F;
  const BlockEdges edges(Errors(pictures.shared, pictures.exact));
  EXPECT_GT(edges.step.mean() - deviations * edges.step.deviation(), visible_step);
}

TEST(BlockEdges, ShowWhereTheRimIsNoisy) {
  Pictures pictures("cloud?lights=2000&blocks=0");
  const glm::uvec2 size = pictures.shared.size;
  for (unsigned y = 0; y < size.y; ++y)
    for (unsigned x = 0; x < size.x; x += side)
      pictures.shared.radiance[std::size_t(y) * size.x + x] *= y % 2 == 0 ? 1.02F : 0.98F;
  const BlockEdges edges(Errors(pictures.shared, pictures.exact));
  EXPECT_GT(edges.error.mean() - deviations * edges.error.deviation(),
            more_on_the_rim * edges.all.mean());
}

} // namespace
} // namespace lightcuts
