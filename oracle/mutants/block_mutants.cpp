// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include <oracle/cases/stress_scene.h>
#include <oracle/mutants/groups.h>
#include <oracle/subjects/block_cuts_subject.h>

namespace lightcuts::oracle {
namespace {

using Views = std::vector<gen::View>;

/// Bounds the block as if its points were others.
template <void alter(Views&)>
class OtherBlock : public CopiedPerThread<OtherBlock<alter>> {
public:
  using CopiedPerThread<OtherBlock<alter>>::CopiedPerThread;
  void block_bounds(std::span<const ShadingPoint> points, std::span<glm::vec3> out) override {
    Views views;
    for (const ShadingPoint& p : points)
      views.push_back({p.position(), p.normal(), p.to_viewer(), p.material()});
    alter(views);
    std::vector<ShadingPoint> altered;
    for (const gen::View& view : views) altered.push_back(view.point());
    LibraryTree::block_bounds(altered, out);
  }
};

void forget_corner(Views& views) {
  const glm::vec3 first = views.front().position;
  for (gen::View& view : views) view.position = glm::min(view.position, first);
}

void keep_first_normal(Views& views) {
  for (gen::View& view : views) view.normal = views.front().normal;
}

void keep_first_material(Views& views) {
  for (gen::View& view : views) view.material = views.front().material;
}

/// With twelve bits, the last of which is rounded down or up.
float in_steps(float value, bool up) {
  int exponent = 0;
  const float steps = std::ldexp(std::frexp(value, &exponent), 12);
  return std::ldexp(up ? std::ceil(steps) : std::floor(steps), exponent - 12);
}

void round_inwards(Views& views) {
  glm::vec3 lo = views.front().position, hi = lo;
  for (const gen::View& view : views) {
    lo = glm::min(lo, view.position);
    hi = glm::max(hi, view.position);
  }
  for (int i = 0; i < 3; ++i) {
    const float least = in_steps(lo[i], true), most = in_steps(hi[i], false);
    if (!(least <= most)) continue; // it would be empty
    for (gen::View& view : views) view.position[i] = std::clamp(view.position[i], least, most);
  }
}

template <BlockSlip slip>
std::unique_ptr<Subject> with_slip(const char* name) {
  return block_cuts_subject(name, slip);
}

constexpr Mutant block_catalogue[] = {
    {"block-corner-forgotten", "lets the box of a block's points end at the first of them",
     with_tree<OtherBlock<forget_corner>>},
    {"block-of-one-normal", "takes the normal of a block's first point for those of all",
     with_tree<OtherBlock<keep_first_normal>>},
    {"block-of-one-material", "takes the reflectance of a block's first point for those of all",
     with_tree<OtherBlock<keep_first_material>>},
    {"block-rounded-inwards", "stores the box of a block's points in steps, rounded inwards",
     with_tree<OtherBlock<round_inwards>>},
    {"block-total-of-another", "ends a point's cut by the total of another point of its block",
     with_slip<BlockSlip::cut_of_another>},
    {"block-share-into-dark", "lets a point see what another point of its block sees",
     with_slip<BlockSlip::eyes_of_another>},
};

} // namespace

std::span<const Mutant> block_mutants() { return block_catalogue; }

} // namespace lightcuts::oracle
