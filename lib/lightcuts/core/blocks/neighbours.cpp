// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/neighbours.h>

#include <algorithm>
#include <variant>

#include <glm/common.hpp>

namespace lightcuts {
namespace {

bool are_alike(const Lobe& a, const Lobe& b) {
  return std::visit(
      [&]<class OneLobe>(OneLobe own) {
        const auto* other = std::get_if<OneLobe>(&b);
        return other != nullptr && own.cover(*other);
      },
      a);
}

/// Along which axis what `of` takes from the points differs most, and by how much.
template <class Of>
std::pair<int, double> widest(std::span<const BlockPoint> points, const Members& members, Of&& of) {
  glm::dvec3 lo(of(points[members.front()].point)), hi = lo;
  for (const std::uint32_t i : members) {
    lo = glm::min(lo, glm::dvec3(of(points[i].point)));
    hi = glm::max(hi, glm::dvec3(of(points[i].point)));
  }
  const glm::dvec3 extent = hi - lo;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  return {axis, extent[axis]};
}

} // namespace

std::vector<Members> groups_of_like_lobes(std::span<const BlockPoint> points) {
  std::vector<Members> groups;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Lobe& lobe = points[i].point.material().lobe;
    const auto like = std::find_if(groups.begin(), groups.end(), [&](const Members& group) {
      return are_alike(points[group.front()].point.material().lobe, lobe);
    });
    if (like != groups.end())
      like->push_back(i);
    else
      groups.push_back({i});
  }
  return groups;
}

std::pair<Members, Members> parted(std::span<const BlockPoint> points, Members members) {
  constexpr double most_turn = 0.2; // of one component of the normal
  const auto position = [](const ShadingPoint& p) { return p.position(); };
  const auto normal = [](const ShadingPoint& p) { return p.normal(); };
  const auto [turn_axis, turn] = widest(points, members, normal);
  const bool by_normal = turn > most_turn;
  const int axis = by_normal ? turn_axis : widest(points, members, position).first;
  const auto where = [&](std::uint32_t i) {
    const ShadingPoint& p = points[i].point;
    return by_normal ? p.normal()[axis] : p.position()[axis];
  };
  std::ranges::stable_sort(members, {}, where);
  const double middle = 0.5 * where(members.front()) + 0.5 * where(members.back());
  auto cut = std::ranges::find_if(members, [&](std::uint32_t i) { return where(i) > middle; });
  if (cut == members.begin() || cut == members.end())
    cut = members.begin() + std::ptrdiff_t(members.size() / 2);
  Members far(cut, members.end());
  members.erase(cut, members.end());
  std::ranges::sort(members);
  std::ranges::sort(far);
  return {std::move(members), std::move(far)};
}

} // namespace lightcuts
