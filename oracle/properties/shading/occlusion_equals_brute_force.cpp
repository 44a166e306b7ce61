// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <lightcuts/core/kernels/transfer.h>
#include <oracle/properties/point_case.h>
#include <oracle/properties/shading/ray_case.h>
#include <oracle/truth/brute_force_occlusion.h>

namespace lightcuts::oracle {
namespace {

void check_ray(const RayCase& of, const Recorder& record) {
  const Scene& scene = of.view.scene();
  const Light& light = scene.lights[of.light];
  // A light behind the surface is never asked for.
  if (transfer(of.from.point, light) == glm::dvec3(0)) return;
  const ShadowRay ray = of.view.ray_to(of.from, of.light);
  ++of.count.rays;
  const Occlusion brute = brute_force_occlusion(scene.mesh, ray);
  if (brute == Occlusion::undecided) {
    ++of.count.undecided;
    return;
  }
  const bool sees = of.subject.sees(of.view, of.from, of.light);
  record(sees == (brute == Occlusion::clear), [&] {
    return fmt::format("from {} to light {} at {}: {}, by brute force {}", digits_of(ray.origin),
                       of.light, digits_of(light.position), sees ? "seen" : "blocked",
                       sees ? "blocked" : "seen");
  });
}

} // namespace

const PropertyInfo property::occlusion_equals_brute_force{
    .name = "occlusion-equals-brute-force",
    .statement = "A light is seen if and only if no triangle at all lies between.",
    .formula = "the answer of the tree of triangles = that of testing each, where rounding can "
               "decide it",
    .needs = only(Part::occlusion),
    .of_ray = check_ray,
};

} // namespace lightcuts::oracle
