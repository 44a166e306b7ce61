// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/shading_block.h>

#include <algorithm>
#include <variant>

#include <lightcuts/core/input_error.h>

namespace lightcuts {
namespace {

bool cover(Lobe& lobe, const Lobe& other) {
  return std::visit(
      [&]<class OneLobe>(OneLobe& own) {
        const auto* same = std::get_if<OneLobe>(&other);
        return same != nullptr && own.cover(*same);
      },
      lobe);
}

BlockDirections directions_of(const ShadingPoint& p) {
  const double cosine = p.viewer_cosine();
  return {{p.normal(), 0}, {p.to_viewer(), 0}, {p.mirror(), 0}, std::max(cosine, 0.0), cosine};
}

} // namespace

ShadingBlock::ShadingBlock(std::span<const ShadingPoint> points) {
  if (points.empty()) throw InputError(InputFault::missing, "block: has no point");
  material_ = points.front().material();
  least_diffuse_ = material_.diffuse;
  directions_ = directions_of(points.front());
  positions_.extend(points.front().position());
  for (const ShadingPoint& point : points.subspan(1)) add(point);
}

void ShadingBlock::add(const ShadingPoint& point) {
  if (!cover(material_.lobe, point.material().lobe))
    throw InputError(InputFault::inconsistent,
                     "block: its points' lobes differ in more than reflectance");
  material_.diffuse = glm::max(material_.diffuse, point.material().diffuse);
  least_diffuse_ = glm::min(least_diffuse_, point.material().diffuse);
  positions_.extend(point.position());
  const BlockDirections own = directions_of(point);
  directions_.normals = merged(directions_.normals, own.normals);
  directions_.viewers = merged(directions_.viewers, own.viewers);
  directions_.mirrors = merged(directions_.mirrors, own.mirrors);
  double& least = directions_.least_viewer_cosine;
  if (least == 0 || (own.least_viewer_cosine > 0 && own.least_viewer_cosine < least))
    least = own.least_viewer_cosine;
  directions_.most_viewer_cosine = std::max(directions_.most_viewer_cosine, own.most_viewer_cosine);
}

} // namespace lightcuts
