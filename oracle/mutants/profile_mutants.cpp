// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include <glm/geometric.hpp>
#include <lightcuts/core/kinds/cone_bounds.h>
#include <lightcuts/core/kinds/horizontal.h>
#include <lightcuts/core/kinds/luminaire.h>
#include <lightcuts/core/lights/profile_envelope.h>
#include <lightcuts/core/lights/profile_lookup.h>
#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

/// Emission of luminaires bounded by `altered`, of all others as it is.
template <double altered(const LightTree& tree, std::uint32_t i, const glm::vec3& from)>
struct ByProfile : AnySuprema {
  double max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                      const glm::vec3& from) const override {
    return kind == LightKind::profile ? altered(tree, i, from)
                                      : AnySuprema::max_emission(tree, i, kind, from);
  }
};

/// The cosine between the cluster's axis and the way from its box's centre.
double cosine_from_centre(const LightTree& tree, std::uint32_t i, const glm::vec3& from) {
  const Box& box = tree.node(i).box;
  const glm::dvec3 way = glm::dvec3(from) - 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  const glm::dvec3 axis(tree.emission(i).cone.axis);
  const double length = glm::length(way) * glm::length(axis);
  return length == 0 ? 1 : glm::dot(way, axis) / length;
}

double rows_beside_centre(const LightTree& tree, std::uint32_t i, const glm::vec3& from) {
  const ProfileTable& table = tree.emission(i).profile->envelope.table();
  const std::size_t row = detail::row_at(table, cosine_from_centre(tree, i, from));
  return std::max(table.shares[row], table.shares[row + 1]);
}

double of_representative_alone(const LightTree& tree, std::uint32_t i, const glm::vec3& from) {
  ClusterEmission e = tree.emission(i);
  const Light& light = tree.lights()[tree.node(i).representative];
  auto profile = std::make_shared<ClusterProfile>(*e.profile);
  profile->profile = light.profile;
  profile->envelope = envelope_of(light.profile);
  e.profile = profile;
  return Luminaire::max_emission(e, DifferenceBox(from, tree.node(i).box));
}

double ends_of_range_alone(const LightTree& tree, std::uint32_t i, const glm::vec3& from) {
  const ClusterEmission& e = tree.emission(i);
  const DifferenceBox q(from, tree.node(i).box);
  const ProfileTable& table = e.profile->envelope.table();
  const auto at = [&](double cosine) {
    return detail::max_share(table, {}, cosine - detail::soft_edge, cosine + detail::soft_edge);
  };
  return std::max(at(detail::min_axis_cosine(e, q)), at(detail::max_axis_cosine(e, q)));
}

double first_half_plane(const LightTree& tree, std::uint32_t i, const glm::vec3& from) {
  const ClusterEmission& e = tree.emission(i);
  const ClusterProfile& cluster = *e.profile;
  const DifferenceBox q(from, tree.node(i).box);
  if (!cluster.one_frame) return Luminaire::max_emission(e, q);
  return detail::max_share(cluster.profile.table(), {},
                           detail::min_axis_cosine(e, q) - detail::soft_edge,
                           detail::max_axis_cosine(e, q) + detail::soft_edge);
}

constexpr Mutant profile_catalogue[] = {
    {"profile-at-centre", "bounds a profile by its rows beside the direction of the box's centre",
     with_suprema<ByProfile<rows_beside_centre>>},
    {"profile-of-representative", "takes the representative's profile for those of all lights",
     with_suprema<ByProfile<of_representative_alone>>},
    {"profile-at-ends", "bounds a profile by the ends of the range of vertical angles",
     with_suprema<ByProfile<ends_of_range_alone>>},
    {"profile-of-one-half-plane", "takes a profile for alike in all half-planes",
     with_suprema<ByProfile<first_half_plane>>},
};

} // namespace

std::span<const Mutant> profile_mutants() { return profile_catalogue; }

} // namespace lightcuts::oracle
