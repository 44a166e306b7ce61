// SPDX-License-Identifier: MIT
#include <oracle/campaign/scene_case.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <oracle/campaign/beside_light.h>
#include <oracle/cases/blocks.h>
#include <oracle/cases/random_pixels.h>

namespace lightcuts::oracle {

namespace {

gen::View view_of(const ShadingPoint& p) {
  return {p.position(), p.normal(), p.to_viewer(), p.material()};
}

Case case_of_lights(const SceneView& view, const CheckConfig& config, std::uint64_t place,
                    std::span<const std::uint32_t> chosen) {
  const LightSet& lights = view.scene().lights;
  const VisiblePoint p = random_point(view, config.seed, place);
  Case c;
  c.min_distance = lights.min_distance();
  CaseView seen{view_of(p.point), {}};
  for (const std::uint32_t i : chosen) {
    if (!view.sees(p, i)) seen.hidden.push_back(std::uint32_t(c.lights.size()));
    c.lights.push_back(lights[i]);
  }
  c.views.push_back(std::move(seen));
  c.cut = config.cut;
  c.seed = config.tree_seed;
  return c;
}

} // namespace

gen::View view_beside_light_at(const SceneView& view, const Topology& topology,
                               const CheckConfig& config, std::uint64_t place) {
  const ShadingPoint p = random_point(view, config.seed, place).point;
  return view_beside_light(view.scene().lights, topology, hashed(config.seed + 4, place),
                           view_of(p));
}

Case block_at(const SceneView& view, const CheckConfig& config, std::uint64_t place) {
  const SeenPixel seen = random_pixel(view, config.seed, place);
  Case block;
  block.views.push_back({view_of(seen.point.point), {}});
  const unsigned step = 1U << hashed(config.seed + 5, place) % 4;
  for (const glm::uvec2 apart : {glm::uvec2(step, 0), glm::uvec2(0, step), glm::uvec2(step)}) {
    const glm::uvec2 pixel = seen.pixel + apart;
    if (pixel.x >= view.size().x || pixel.y >= view.size().y) continue;
    const auto neighbour = view.at(pixel);
    if (!neighbour) continue;
    block.views.push_back({view_of(neighbour->point), {}});
    if (!is_block(block)) block.views.pop_back();
  }
  return block;
}

Case case_of(const Subject& subject, const SceneView& view, const CheckConfig& config,
             std::uint64_t place) {
  std::vector<std::uint32_t> all(view.scene().lights.size());
  std::iota(all.begin(), all.end(), 0U);
  Case c = case_of_lights(view, config, place, all);
  if (is_of_block(place)) {
    const Case block = block_at(view, config, place);
    c.views.insert(c.views.end(), block.views.begin() + 1, block.views.end());
  }
  if (!is_beside_light(place)) return c;
  const auto tree = subject.build(view.scene().lights, config.tree_seed);
  const TopologyReading reading = read_topology(tree->claim(), all.size());
  if (reading.topology)
    c.views.front() = {view_beside_light_at(view, *reading.topology, config, place), {}};
  return c;
}

Case excerpt_of(const SceneView& view, const CheckConfig& config, std::uint64_t place) {
  constexpr std::size_t most = 12;
  const std::size_t count = view.scene().lights.size();
  std::vector<std::uint32_t> chosen;
  for (std::uint64_t i = 0; i < std::min(most, count); ++i)
    chosen.push_back(std::uint32_t(hashed(hashed(config.seed + 3, place), i) % count));
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Case c = case_of_lights(view, config, place, chosen);
  constexpr std::uint64_t every = 16 * points_per_full_check; // a second each
  c.draws = place % every == 0 && place / every < most_cases_with_draws;
  return c;
}

std::optional<Counterexample> counterexample_of(const Subject& subject, const SceneView& view,
                                                const CheckConfig& config,
                                                const CheckResult& result) {
  for (const Property property : broken(result.tally)) {
    const std::uint64_t place = result.tally[property].first_place;
    if (place >= result.points) continue;
    for (const bool all : {true, false}) {
      Case on = all ? case_of(subject, view, config, place) : excerpt_of(view, config, place);
      if (auto message = failure_of(subject, property, on))
        return Counterexample{property, std::move(on), std::move(*message), place};
    }
  }
  return std::nullopt;
}

} // namespace lightcuts::oracle
