// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <oracle/properties/point_case.h>
#include <oracle/properties/shading/proof_case.h>
#include <oracle/truth/brute_force_occlusion.h>

namespace lightcuts::oracle {
namespace {

void check_proof(const ProofCase& of, const Recorder& record) {
  const Scene& scene = of.view.scene();
  const ShadowRay ray = of.view.ray_to(of.from, of.light);
  const Occlusion brute = brute_force_occlusion(scene.mesh, ray);
  // Too near an edge for rounding to decide, a ray answers all the same: that is what is saved.
  const bool blocked = brute == Occlusion::undecided ? of.view.occluder().occluded(ray)
                                                     : brute == Occlusion::blocked;
  const bool hidden = of.sight == ProvenSight::hidden;
  record(blocked == hidden, [&] {
    return fmt::format("from {} to light {} at {}: proven {} with all of node {}, but {}{}",
                       digits_of(ray.origin), of.light, digits_of(scene.lights[of.light].position),
                       hidden ? "hidden" : "seen", of.node, blocked ? "blocked" : "seen",
                       brute == Occlusion::undecided ? " (by a ray)" : "");
  });
}

} // namespace

const PropertyInfo property::proven_visibility_holds{
    .name = "proven-visibility-holds",
    .statement =
        "What is proven of a block of points and a cluster is so for each point and light.",
    .formula = "for each point and each light: proven hidden = a triangle lies between, by testing "
               "all, or by a ray where rounding decides it",
    .needs = only(Part::proofs),
    .of_proof = check_proof,
};

} // namespace lightcuts::oracle
