// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/profile.h>

#include <cmath>
#include <string>
#include <utility>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/number_text.h>

namespace lightcuts {
namespace {

[[noreturn]] void refuse_entry(const char* field, std::size_t i, float value, const char* why) {
  throw InputError(std::isfinite(value) ? InputFault::out_of_domain : InputFault::not_finite,
                   std::string(field) + " " + std::to_string(i) + " is " + number_text(value) +
                       ", " + why);
}

[[noreturn]] void refuse_size(const char* what) {
  throw InputError(InputFault::inconsistent, std::string("a profile has ") + what);
}

void require_domains(const ProfileTable& table) {
  for_each_field(table, [](const char* field, const std::vector<float>& list, const Domain& in) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!(list[i] >= in.least && list[i] <= in.most)) // NaN is not
        refuse_entry(field, i, list[i], "out of its domain");
  });
}

/// Whether the angle is pi or more.
bool in_second_half(float cosine, float sine) { return sine < 0 || (sine == 0 && cosine < 0); }

/// Sine of the angle from half-plane i to k, times their lengths; the sign is exact.
double turn(const ProfileTable& table, std::size_t i, std::size_t k) {
  return double(table.plane_cosines[i]) * table.plane_sines[k] -
         double(table.plane_sines[i]) * table.plane_cosines[k];
}

void require_planes(const ProfileTable& table) {
  const std::size_t count = table.planes();
  for (std::size_t i = 0; i < count; ++i) {
    const double c = table.plane_cosines[i], s = table.plane_sines[i];
    if (!(std::abs(std::sqrt(c * c + s * s) - 1) <= 1e-5))
      refuse_entry("plane_cosines", i, table.plane_cosines[i], "not unit with the sine");
  }
  if (count == 1) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(turn(table, i, (i + 1) % count) > 0))
      refuse_entry("plane_sines", i, table.plane_sines[i],
                   "expected the next half-plane less than pi farther");
    if (i > 0 && in_second_half(table.plane_cosines[i - 1], table.plane_sines[i - 1]) &&
        !in_second_half(table.plane_cosines[i], table.plane_sines[i]))
      refuse_entry("plane_sines", i, table.plane_sines[i], "expected increasing angles");
  }
}

} // namespace

Profile::Profile(ProfileTable table) {
  if (table.rows() < 2) refuse_size("less than two cosines");
  if (table.planes() == 0 || table.planes() != table.plane_sines.size())
    refuse_size("not as many plane_sines as plane_cosines, at least one");
  if (table.rows() > max_shares || table.planes() > max_shares / table.rows())
    throw InputError(InputFault::too_large, "a profile has more than 2^22 shares");
  if (table.shares.size() != table.rows() * table.planes())
    refuse_size("not a share for each cosine and half-plane");
  require_domains(table);
  if (table.cosines.front() != 1) refuse_entry("cosines", 0, table.cosines.front(), "expected 1");
  if (table.cosines.back() != -1)
    refuse_entry("cosines", table.rows() - 1, table.cosines.back(), "expected -1");
  for (std::size_t i = 1; i < table.rows(); ++i)
    if (!(table.cosines[i] < table.cosines[i - 1]))
      refuse_entry("cosines", i, table.cosines[i], "expected less than the one before");
  require_planes(table);
  table_ = std::make_shared<const ProfileTable>(std::move(table));
}

const ProfileTable& Profile::table() const {
  static const ProfileTable alike;
  return table_ ? *table_ : alike;
}

} // namespace lightcuts
