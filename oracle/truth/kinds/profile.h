// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>
#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

/// The table as ProfileTable defines it, looked up from one end to the other.
template <>
struct KindTruth<LightKind::profile> : UsualKind {
  template <class Real>
  static Real emission(const Light& light, const glm::vec3& x, const Real& distance) {
    const ProfileTable& table = light.profile.table();
    const Real cosine = axis_cosine(light, x, distance);
    // The cosine less that of the row; of the first not above 0, of the last not below, whatever
    // the last bit says.
    Real above = beyond_cosine(light, x, cosine, 1);
    if (above > 0) above = Real(0);
    for (std::size_t row = 1; row < table.rows(); ++row) {
      Real below = beyond_cosine(light, x, cosine, table.cosines[row]);
      if (below < 0 && row + 1 == table.rows()) below = Real(0);
      if (below >= 0) {
        const Real height = Real(table.cosines[row - 1]) - Real(table.cosines[row]);
        return around(light, x, [&](std::size_t plane) {
          return Real(
              (Real(table.share(plane, row - 1)) * below - Real(table.share(plane, row)) * above) /
              height);
        });
      }
      above = below;
    }
    return Real(0);
  }

  static void finish(gen::Dice& dice, Light& light, const glm::vec3& x) {
    light.axis = dice.direction(light.position, x);
    const glm::dvec3 a(light.axis);
    glm::dvec3 side(0);
    do side = glm::cross(a, glm::dvec3(dice.unit_vector()));
    while (!(glm::length(side) > 1e-3));
    light.plane = glm::vec3(glm::normalize(side));
    light.profile = Profile(random_table(dice));
  }

private:
  /// E_i of ProfileTable: of a half-plane with this cosine and sine. Where it cancels, in 700 bits.
  template <class Real>
  static Real past(const Light& light, const glm::vec3& x, float cosine, float sine) {
    const glm::vec3 &u = light.plane, &a = light.axis, &y = light.position;
    Real sum(0), magnitude(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = int(i), next = int((i + 1) % 3), last = int((i + 2) % 3);
      const Real d = Real(x[k]) - Real(y[k]);
      const Real turned[] = {Real(u[next]) * Real(a[last]) * Real(cosine) * d,
                             -Real(u[last]) * Real(a[next]) * Real(cosine) * d,
                             -Real(u[k]) * Real(sine) * d};
      for (const Real& term : turned) {
        sum += term;
        magnitude += term < 0 ? Real(-term) : term;
      }
    }
    if constexpr (!std::is_same_v<Real, Exact>) {
      const Real size = sum < 0 ? Real(-sum) : sum;
      if (!(size >= magnitude * Real(0x1p-16))) return Real(past<Exact>(light, x, cosine, sine));
    }
    return sum;
  }

  /// What the half-planes, share(index) each, have where light leaves towards x.
  template <class Real, class Share>
  static auto around_of(const Light& light, const glm::vec3& x, const Share& share) {
    const ProfileTable& table = light.profile.table();
    const auto at = [&](std::size_t i) {
      return past<Real>(light, x, table.plane_cosines[i], table.plane_sines[i]);
    };
    const std::size_t count = table.planes();
    if (count == 1) return share(0);
    Real since = at(0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const Real until = at(next);
      if (since >= 0 && until < 0)
        return Real((share(i) * -until + share(next) * since) / (since - until));
      since = until;
    }
    return share(0);
  }
  template <class Share>
  static auto around(const Light& light, const glm::vec3& x, const Share& share) {
    return around_of<decltype(share(std::size_t(0)))>(light, x, share);
  }

  static ProfileTable random_table(gen::Dice& dice) {
    ProfileTable table;
    table.cosines = random_cosines(dice);
    if (dice.one_in(2)) set_random_planes(dice, table);
    const bool sharp = dice.one_in(2);
    table.shares.clear();
    for (std::size_t i = 0; i < table.rows() * table.planes(); ++i)
      table.shares.push_back(sharp ? dice.pick({0.0F, 0.0F, 1.0F, 0.5F, 0x1p-20F, 0x1p-149F})
                                   : float(dice.uniform(0, 1)));
    return table;
  }
  /// From 1 to -1, some of them close together.
  static std::vector<float> random_cosines(gen::Dice& dice) {
    std::vector<float> list{1, -1};
    for (int i = dice.between(0, 6); i > 0; --i) {
      const float any = float(dice.uniform(-1, 1));
      list.push_back(dice.pick({any, any, 0.0F, 0.5F, 1 - 0x1p-20F}));
      if (dice.one_in(4)) list.push_back(std::nextafter(list.back(), 0.25F));
    }
    std::sort(list.begin(), list.end(), std::greater<>());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }
  /// Three to eight, evenly apart, but for one sector that may be a thousandth as wide.
  static void set_random_planes(gen::Dice& dice, ProfileTable& table) {
    const int count = dice.between(3, 8);
    const double start = dice.one_in(2) ? 0 : dice.uniform(0, 2 * std::numbers::pi / (count + 1));
    table.plane_cosines.clear();
    table.plane_sines.clear();
    const auto add = [&](double angle) {
      const double c = std::cos(angle), s = std::sin(angle);
      table.plane_cosines.push_back(std::abs(c) < 1e-9 ? 0 : float(c));
      table.plane_sines.push_back(std::abs(s) < 1e-9 ? 0 : float(s));
    };
    for (int i = 0; i < count; ++i) {
      const double angle = start + 2 * std::numbers::pi * i / count;
      add(angle);
      if (i == 0 && dice.one_in(4)) add(angle + 1e-3 * dice.uniform(0.5, 1));
    }
  }
};

} // namespace lightcuts::oracle::radiometry
