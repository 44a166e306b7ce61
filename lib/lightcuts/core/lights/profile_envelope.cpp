// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/profile_envelope.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include <lightcuts/core/lights/profile_lookup.h>
#include <lightcuts/core/numerics/rounding.h>

namespace lightcuts {
namespace {

/// At least the share of a profile that is alike in all half-planes.
float share_at(const ProfileTable& table, float cosine) {
  const detail::Between rows = detail::rows_at(table, cosine);
  // An end of a cell has its own share, to the bit.
  if (rows.next_weight == 0) return table.shares[rows.first];
  if (rows.weight == 0) return table.shares[rows.next];
  const double share = detail::share_between(table, {}, rows);
  return std::min(1.0F, round_up(share * (1 + 0x1p-48)));
}

std::vector<float> cosines_of_both(const ProfileTable& a, const ProfileTable& b) {
  std::vector<float> all;
  std::set_union(a.cosines.begin(), a.cosines.end(), b.cosines.begin(), b.cosines.end(),
                 std::back_inserter(all), std::greater<>());
  return all;
}

/// Every so many of the rows, with the largest share up to those beside.
ProfileTable coarser(const ProfileTable& fine) {
  const std::size_t cells = max_envelope_rows - 1, last = fine.rows() - 1;
  const auto row = [&](std::size_t i) { return i * last / cells; };
  ProfileTable coarse;
  coarse.cosines.clear();
  coarse.shares.clear();
  for (std::size_t i = 0; i <= cells; ++i) {
    const auto begin = fine.shares.begin() + std::ptrdiff_t(row(i == 0 ? 0 : i - 1));
    const auto end = fine.shares.begin() + std::ptrdiff_t(row(std::min(i + 1, cells)) + 1);
    coarse.cosines.push_back(fine.cosines[row(i)]);
    coarse.shares.push_back(*std::max_element(begin, end));
  }
  return coarse;
}

} // namespace

Profile envelope_of(const Profile& profile) {
  const ProfileTable& table = profile.table();
  if (table.is_round()) return profile;
  ProfileTable envelope;
  envelope.cosines = table.cosines;
  envelope.shares.assign(table.shares.begin(), table.shares.begin() + std::ptrdiff_t(table.rows()));
  for (std::size_t plane = 1; plane < table.planes(); ++plane)
    for (std::size_t row = 0; row < table.rows(); ++row)
      envelope.shares[row] = std::max(envelope.shares[row], table.share(plane, row));
  return Profile(std::move(envelope));
}

Profile united(const Profile& a, const Profile& b) {
  if (a == b) return a;
  ProfileTable both;
  both.cosines = cosines_of_both(a.table(), b.table());
  both.shares.clear();
  for (const float cosine : both.cosines)
    both.shares.push_back(std::max(share_at(a.table(), cosine), share_at(b.table(), cosine)));
  if (both.rows() > max_envelope_rows) both = coarser(both);
  if (both == a.table()) return a;
  if (both == b.table()) return b;
  return Profile(std::move(both));
}

} // namespace lightcuts
