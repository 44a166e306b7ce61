// SPDX-License-Identifier: MIT
#include <oracle/properties/point_case.h>

#include <fmt/format.h>

namespace lightcuts::oracle {

std::string digits_of(const glm::dvec3& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

std::string PointCase::text() const { return "point " + digits_of(point.position()); }

glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node, const PointCase& at,
                         const glm::vec3& bound) {
  const std::uint32_t index = at.topology().representative(node);
  if (index != TreeClaim::unsaid && at.visible[index] == 0) {
    const Light& light = at.lights()[index];
    const glm::vec3 from = viewed_from(light.kind, at.point.position());
    if (dot_between(at.point.normal(), from, light.position) > 0) return glm::dvec3(0);
  }
  return judged.tree.estimate(node, at.point, bound);
}

glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node, const PointCase& at) {
  return seen_estimate(judged, node, at, judged.tree.bound(node, at.point));
}

std::span<const glm::vec3> PointAnswers::bounds() const {
  if (bounds_.empty()) {
    bounds_.resize(topology().size());
    judged.tree.bounds(at.point, bounds_);
  }
  return bounds_;
}

std::span<const glm::dvec3> PointAnswers::estimates() const {
  if (estimates_.empty()) {
    estimates_.reserve(topology().size());
    for (std::uint32_t i = 0; i < topology().size(); ++i)
      estimates_.push_back(seen_estimate(judged, i, at, bounds()[i]));
  }
  return estimates_;
}

glm::dvec3 PointAnswers::open_estimate(std::uint32_t node) const {
  const std::uint32_t light = topology().representative(node);
  if (light == TreeClaim::unsaid || at.sees(light)) return estimates()[node];
  return judged.tree.estimate(node, at.point, bounds()[node]);
}

Cut PointAnswers::select(const CutConfig& config, bool all_seen) const {
  return judged.tree.select(at.point, config,
                            [&](std::uint32_t light) { return all_seen || at.sees(light); });
}

} // namespace lightcuts::oracle
