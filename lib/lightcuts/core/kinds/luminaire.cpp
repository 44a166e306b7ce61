// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/luminaire.h>

#include <algorithm>
#include <cmath>

#include <lightcuts/core/kinds/cone_bounds.h>
#include <lightcuts/core/kinds/horizontal.h>
#include <lightcuts/core/kinds/rim_distance.h>
#include <lightcuts/core/kinds/towards.h>
#include <lightcuts/core/lights/profile_lookup.h>

namespace lightcuts {

// Relative error 2^-31: weights of rows err by 2^-33, of half-planes by 2^-35, and nothing is
// subtracted after that.
double Luminaire::emission_from(const Light& light, const glm::vec3& position, const glm::vec3& x) {
  const detail::AxisCosine towards = detail::axis_cosine(light.axis, position, x);
  if (!towards.defined) return 0;
  const ProfileTable& table = light.profile.table();
  const auto beyond = [&](std::size_t row) {
    return detail::rim_distance(light.axis, position, x, towards.cosine, table.cosines[row]);
  };
  std::size_t row = detail::row_at(table, towards.cosine);
  while (row > 0 && beyond(row) > 0) --row;
  while (row + 2 < table.rows() && beyond(row + 1) < 0) ++row;
  const detail::Between rows{row, row + 1, beyond(row + 1), -beyond(row)};
  const detail::HorizontalAngle angle(table, light.axis, light.plane, position, x);
  return std::min(1.0, share_between(table, angle.sector(), rows));
}

double Luminaire::max_emission(const ClusterEmission& e, const DifferenceBox& q) {
  const double least = detail::min_axis_cosine(e, q) - detail::soft_edge;
  const double most = detail::max_axis_cosine(e, q) + detail::soft_edge;
  const ClusterProfile& cluster = *e.profile;
  double share = 0;
  if (cluster.one_frame && !cluster.profile.table().is_round()) {
    const detail::HorizontalRange range(e.cone.axis, cluster.plane, q);
    share = range.max_share(cluster.profile.table(), cluster.envelope.table(), least, most);
  } else {
    share = detail::max_share(cluster.envelope.table(), {}, least, most);
  }
  return std::min(1.0, share * (1 + 0x1p-48));
}

} // namespace lightcuts
