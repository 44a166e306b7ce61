// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {

/// How much of a luminaire's intensity goes where: a table over vertical angles, from the light's
/// axis on, and half-planes around the axis. Floats are taken as exact real numbers.
///
/// For a direction d, of length 1, in which light leaves, let c = a.d with a the unit axis, and
/// (P, Q) = (d.u, d.(u x a)) with u Light::plane. Between two of `cosines` the share is linear in
/// c. Between two half-planes j and k, with E_i = plane_cosines_i Q - plane_sines_i P, it is the
/// mean of theirs by the weights -E_k and E_j: linear along the chord between them, and within
/// 0.3 % of the difference of the two of being linear in the angle where they are at most 22.5
/// degrees apart. Where P = Q = 0 it is that of the first half-plane.
struct ProfileTable {
  std::vector<float> cosines{1, -1};   ///< of two or more vertical angles, from 1 to -1, each less
                                       ///< than the one before
  std::vector<float> plane_cosines{1}; ///< cosine and sine of the horizontal angles, increasing in
  std::vector<float> plane_sines{0};   ///< [0, 2 pi), less than pi apart all round; or one alone:
                                       ///< alike in all of them. Of about unit length
  std::vector<float> shares{1, 1};     ///< in [0, 1]; of the first half-plane for all vertical
                                       ///< angles, then of the next

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("cosines", &ProfileTable::cosines, domain::within(-1, 1));
    field("plane_cosines", &ProfileTable::plane_cosines, domain::within(-1, 1));
    field("plane_sines", &ProfileTable::plane_sines, domain::within(-1, 1));
    field("shares", &ProfileTable::shares, domain::within(0, 1));
  }
  bool operator==(const ProfileTable&) const = default;

  [[nodiscard]] std::size_t rows() const { return cosines.size(); }
  [[nodiscard]] std::size_t planes() const { return plane_cosines.size(); }
  /// Alike in all half-planes.
  [[nodiscard]] bool is_round() const { return planes() == 1; }
  [[nodiscard]] float share(std::size_t plane, std::size_t row) const {
    return shares[plane * rows() + row];
  }
};

/// A ProfileTable that copies share, never changed; by default one that shines alike everywhere.
class Profile {
public:
  using Table = ProfileTable;
  /// Most numbers of a table.
  static constexpr std::size_t max_shares = std::size_t(1) << 22;

  Profile() = default;
  /// Throws InputError, naming the field, where the table is not as described.
  explicit Profile(ProfileTable table);

  [[nodiscard]] const ProfileTable& table() const;
  [[nodiscard]] bool is_same_object(const Profile& other) const { return table_ == other.table_; }
  bool operator==(const Profile& other) const {
    return is_same_object(other) || table() == other.table();
  }

private:
  std::shared_ptr<const ProfileTable> table_; ///< none: the default one
};

} // namespace lightcuts
