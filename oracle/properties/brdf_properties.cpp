// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <oracle/properties/point_properties.h>
#include <oracle/truth/reciprocity.h>
#include <oracle/truth/white_furnace.h>

namespace lightcuts::oracle {
namespace {

std::string text(const glm::vec3& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

std::string name_of(const NoLobe& /*lobe*/) { return "diffuse"; }
std::string name_of(const Phong& phong) {
  return fmt::format("Phong, exponent {:g}", phong.exponent);
}
std::string name_of(const Ward& ward) { return fmt::format("Ward, alpha {:g}", ward.alpha); }
std::string name_of(const CookTorrance& lobe) {
  return fmt::format("Cook-Torrance, alpha {:g}", lobe.alpha);
}

/// Between viewer and normal, in degrees.
constexpr std::array viewer_angles{0.0, 45.0, 75.0, 85.0, 89.9};

} // namespace

void check_reciprocity(const PointCase& at, const Light& light, Tally& tally) {
  const glm::vec3 &n = at.point.normal(), &v = at.point.to_viewer();
  const glm::dvec3 q =
      glm::dvec3(light.position) - glm::dvec3(viewed_from(light.kind, at.point.position()));
  const double distance = glm::length(q);
  if (!(distance > 0)) return;
  const glm::vec3 l(q / distance);
  if (dot_between(n, glm::vec3(0), l) <= 0 || at.point.viewer_cosine() <= 0) return;
  const BothWays f = both_ways(at.point.material(), n, l, v);
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double difference = std::abs(f.there[c] - f.back[c]);
    holds = holds && difference <= f.allowed[c];
    worst = std::max(worst, ratio_of(difference, f.allowed[c]));
  }
  tally.record(Property::brdf_is_reciprocal, holds, at.place, worst, [&] {
    return fmt::format("n {}, l {}, v {}: f n.l n.v {} there, {} back", text(n), text(l), text(v),
                       text(f.there), text(f.back));
  });
}

void check_energy(const Lobe& lobe, std::uint64_t place, Tally& tally) {
  std::visit(
      [&](const auto& part) {
        for (const double degrees : viewer_angles) {
          const double angle = degrees * (std::numbers::pi / 180);
          const Furnace furnace = white_furnace(part, angle);
          const double most = most_reflected(part, std::cos(angle)) + furnace.error;
          tally.record(Property::brdf_conserves_energy, furnace.value <= most, place,
                       ratio_of(furnace.value, most), [&] {
                         return fmt::format("{}, viewer at {:g} degrees: reflects {:.9g}, "
                                            "at most {:.9g}",
                                            name_of(part), degrees, furnace.value, most);
                       });
        }
      },
      lobe);
}

} // namespace lightcuts::oracle
