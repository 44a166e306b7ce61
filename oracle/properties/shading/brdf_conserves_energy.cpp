// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <oracle/properties/properties.h>
#include <oracle/records/record_text.h>
#include <oracle/truth/white_furnace.h>

namespace lightcuts::oracle {
namespace {

/// Between viewer and normal, in degrees.
constexpr std::array viewer_angles{0.0, 45.0, 75.0, 85.0, 89.9};

template <class OneLobe>
void check_lobe(const OneLobe& lobe, const Recorder& record) {
  for (const double degrees : viewer_angles) {
    const double angle = degrees * (std::numbers::pi / 180);
    const Furnace furnace = white_furnace(lobe, angle);
    const double most = most_reflected(lobe, std::cos(angle)) + furnace.error;
    record(furnace.value <= most, ratio_of(furnace.value, most), [&] {
      return fmt::format("lobe {}, viewer at {:g} degrees: reflects {:.9g}, at most {:.9g}",
                         text_of(Lobe(lobe)), degrees, furnace.value, most);
    });
  }
}

void check_energy(const Lobe& lobe, const Recorder& record) {
  std::visit([&](const auto& one) { check_lobe(one, record); }, lobe);
}

} // namespace

const PropertyInfo property::brdf_conserves_energy{
    .name = "brdf-conserves-energy",
    .statement = "Each part of a material reflects no more light than there is, its reflectance "
                 "being 1.",
    .formula = "integral of f n.l over the hemisphere <= 1 + error of the quadrature; Ward's, near "
               "the horizon: <= max(1, min(0.068, 0.37 alpha^1.5) / sqrt(n.v)) + error",
    .of_lobe = check_energy,
};

} // namespace lightcuts::oracle
