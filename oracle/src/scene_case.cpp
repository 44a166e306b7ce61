// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/scene_case.h>

#include <lightcuts/oracle/check_case.h>
#include <lightcuts/oracle/random_pixels.h>

namespace lightcuts::oracle {

Case case_of(const SceneView& view, const CheckConfig& config, std::uint64_t place) {
  const LightSet& lights = view.scene().lights;
  const VisiblePoint p = random_point(view, config.seed, place);
  Case c;
  c.lights.assign(lights.begin(), lights.end());
  c.min_distance = lights.min_distance();
  CaseView seen{{p.point.position(), p.point.normal(), p.point.to_viewer(), p.point.material()},
                {}};
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (!view.sees(p, i)) seen.hidden.push_back(i);
  c.views.push_back(std::move(seen));
  c.cut = config.cut;
  c.seed = config.tree_seed;
  return c;
}

std::optional<Counterexample> counterexample_of(const Subject& subject, const SceneView& view,
                                                const CheckConfig& config,
                                                const CheckResult& result) {
  for (const Property property : broken(result.tally)) {
    const std::uint64_t place = result.tally[property].first_place;
    if (place >= result.points) continue;
    Case on = case_of(view, config, place);
    if (auto message = failure_of(subject, property, on))
      return Counterexample{property, std::move(on), std::move(*message), place};
    // Of the cuts that check() looks at, the one that check_case() does not.
    on.cut.max_size = small_cut_size;
    if (auto message = failure_of(subject, property, on))
      return Counterexample{property, std::move(on), std::move(*message), place};
  }
  return std::nullopt;
}

} // namespace lightcuts::oracle
