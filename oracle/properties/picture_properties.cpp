// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/renderer.h>
#include <oracle/properties/case_properties.h>
#include <oracle/truth/brute_force_occlusion.h>

namespace lightcuts::oracle {
namespace {

void check_pixel(const Rendering& picture, const SceneView& view, CutSelector& select,
                 glm::uvec2 pixel, std::uint64_t place, Tally& tally) {
  const glm::vec3 shown = picture.radiance[std::size_t(pixel.y) * view.size().x + pixel.x];
  glm::vec3 expected(0);
  if (const auto p = view.at(pixel))
    expected = select(p->point, [&](std::uint32_t light) { return view.sees(*p, light); }).radiance;
  const auto text = [&] {
    return fmt::format("pixel ({}, {}): ({:.9g}, {:.9g}, {:.9g}), its point has ({:.9g}, {:.9g}, "
                       "{:.9g})",
                       pixel.x, pixel.y, shown.x, shown.y, shown.z, expected.x, expected.y,
                       expected.z);
  };
  tally.record(Property::pixels_equal_points, shown == expected, place, no_ratio, text);
  tally.record(Property::results_are_finite, shown.x >= 0 && shown.y >= 0 && shown.z >= 0, place,
               no_ratio, text);
}

} // namespace

void check_ray(const Subject& subject, const SceneView& view, const VisiblePoint& from,
               std::uint32_t light, std::uint64_t place, RayCount& count, Tally& tally) {
  const Light& the_light = view.scene().lights[light];
  // A light behind the surface is never asked for.
  if (transfer(from.point, the_light) == glm::dvec3(0)) return;
  const ShadowRay ray = view.ray_to(from, light);
  ++count.rays;
  const Occlusion brute = brute_force_occlusion(view.scene().mesh, ray);
  if (brute == Occlusion::undecided) {
    ++count.undecided;
    return;
  }
  const bool sees = subject.sees(view, from, light);
  tally.record(Property::occlusion_equals_brute_force, sees == (brute == Occlusion::clear), place,
               no_ratio, [&] {
                 const glm::vec3& o = ray.origin;
                 const glm::vec3& y = the_light.position;
                 return fmt::format("from ({:.9g}, {:.9g}, {:.9g}) to light {} at ({:.9g}, "
                                    "{:.9g}, {:.9g}): {}, by brute force {}",
                                    o.x, o.y, o.z, light, y.x, y.y, y.z, sees ? "seen" : "blocked",
                                    sees ? "blocked" : "seen");
               });
}

void check_picture(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally) {
  const Scene scene = on.scene();
  const SceneView view(scene);
  const LightTree tree = build(scene.lights, {on.seed});
  CutConfig cut = on.cut;
  cut.unoccluded = !view.may_occlude();
  CutSelector select(tree, cut);
  const bool pictures = has(subject.parts(), Part::pictures);
  Rendering picture;
  if (pictures) picture = subject.render(view, tree, {.cut = on.cut, .threads = 1});
  RayCount count;
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x) {
      if (pictures) check_pixel(picture, view, select, {x, y}, place, tally);
      if (!has(subject.parts(), Part::occlusion)) continue;
      if (const auto p = view.at({x, y}))
        for (std::uint32_t light = 0; light < scene.lights.size(); ++light)
          check_ray(subject, view, *p, light, place, count, tally);
    }
}

} // namespace lightcuts::oracle
