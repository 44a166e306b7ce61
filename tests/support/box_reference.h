// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include <lightcuts/core/geometry/box.h>
#include <tests/support/precise.h>

/// The box bounds by another road: a finite list of candidate points instead of a path.
namespace lightcuts::precise {

using Point = std::array<Exact, 3>; ///< q = y - x

/// The box as seen from x.
struct ExactBox {
  Point lo, hi;

  ExactBox(const glm::vec3& x, const Box& box) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = Exact(box.lo[i]) - Exact(x[i]);
      hi[i] = Exact(box.hi[i]) - Exact(x[i]);
    }
  }
  [[nodiscard]] bool contains(const Point& q) const {
    for (int i = 0; i < 3; ++i)
      if (q[i] < lo[i] || q[i] > hi[i]) return false;
    return true;
  }
  /// The corner whose bits say hi.
  [[nodiscard]] Point corner(int bits) const {
    Point q;
    for (int i = 0; i < 3; ++i) q[i] = (bits >> i) & 1 ? hi[i] : lo[i];
    return q;
  }
};

inline Exact dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Point exact_vector(const glm::vec3& n) { return {Exact(n.x), Exact(n.y), Exact(n.z)}; }

/// max(0, n.q) / |q|^K, and 0 at q = 0.
template <int K>
Exact objective(const Point& n, const Point& q) {
  const Exact d2 = dot(q, q);
  const Exact top = dot(n, q);
  if (top <= 0) return 0;
  return K == 1 ? Exact(top / sqrt(d2)) : Exact(top / (d2 * sqrt(d2)));
}

/// The t > 0 with (K - 1) m t^2 + K a t = c, c >= 0: where K t n.q = |q|^2 for q = t n along the
/// free axes (m the sum of their n^2), n.q = a and |q|^2 = c along the others.
template <int K>
std::optional<Exact> root(const Exact& m, const Exact& a, const Exact& c) {
  if constexpr (K == 1) {
    if (a <= 0) return std::nullopt;
    return Exact(c / a);
  } else {
    const Exact discriminant = sqrt(9 * a * a + 8 * m * c);
    if (a > 0) return Exact(2 * c / (3 * a + discriminant));
    if (m == 0) return std::nullopt;
    return Exact((discriminant - 3 * a) / (4 * m));
  }
}

/// Corners, and the stationary points of edges and faces that lie in the box: one of them has the
/// largest objective, unless x is in the box or (K = 1) the ray along n meets it.
template <int K>
std::vector<Point> candidates(const Point& n, const ExactBox& box) {
  std::vector<Point> list;
  for (int free = 0; free < 7; ++free)
    for (int bits = 0; bits < 8; ++bits) {
      if ((free & bits) != 0) continue;
      Point q = box.corner(bits);
      if (free != 0) {
        Exact m = 0, a = 0, c = 0;
        for (int i = 0; i < 3; ++i) {
          const bool is_free = (free >> i) & 1;
          if (is_free)
            m += n[i] * n[i];
          else
            a += n[i] * q[i], c += q[i] * q[i];
        }
        const auto t = root<K>(m, a, c);
        if (!t) continue;
        for (int i = 0; i < 3; ++i)
          if ((free >> i) & 1) q[i] = *t * n[i];
        if (!box.contains(q)) continue;
      }
      list.push_back(q);
    }
  return list;
}

template <int K>
Exact largest_candidate(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  Exact best = 0;
  for (const Point& q : candidates<K>(exact_vector(n), ExactBox(x, box)))
    best = std::max(best, objective<K>(exact_vector(n), q));
  return best;
}

/// Some t > 0 has t n in the box.
inline bool ray_meets(const Point& n, const ExactBox& box) {
  std::optional<Exact> last;
  Exact first = 0;
  for (int i = 0; i < 3; ++i) {
    if (n[i] == 0) {
      if (box.lo[i] > 0 || box.hi[i] < 0) return false;
      continue;
    }
    const Exact near = (n[i] > 0 ? box.lo[i] : box.hi[i]) / n[i];
    const Exact far = (n[i] > 0 ? box.hi[i] : box.lo[i]) / n[i];
    first = std::max(first, near);
    last = last ? std::min(*last, far) : far;
  }
  return last && *last > 0 && first <= *last;
}

/// sup of max(0, n.q)/|q|, q != 0. From within the box the directions are those of a corner, an
/// edge's wedge, a half space or all space: the projection of n onto them.
inline Exact max_cosine(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  const ExactBox b(x, box);
  const Point e = exact_vector(n);
  if (ray_meets(e, b)) return sqrt(dot(e, e));
  if (!box.contains(x)) return largest_candidate<1>(n, x, box);
  Exact sum = 0;
  for (int i = 0; i < 3; ++i)
    if (n[i] > 0 ? b.hi[i] > 0 : b.lo[i] < 0) sum += e[i] * e[i];
  return sqrt(sum);
}

/// n.q > 0 somewhere in the box: at a corner, then.
inline bool reaches_front(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  const ExactBox b(x, box);
  for (int bits = 0; bits < 8; ++bits)
    if (dot(exact_vector(n), b.corner(bits)) > 0) return true;
  return false;
}

/// sup of max(0, n.q)/|q|^3; nothing where it is infinite.
inline std::optional<Exact> max_cosine_over_distance2(const glm::vec3& n, const glm::vec3& x,
                                                      const Box& box) {
  if (!reaches_front(n, x, box)) return Exact(0);
  if (box.contains(x)) return std::nullopt;
  return largest_candidate<3>(n, x, box);
}

/// min |q|^2.
inline Exact min_distance2(const glm::vec3& x, const Box& box) {
  const ExactBox b(x, box);
  Exact sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += square(b.lo[i] > 0 ? b.lo[i] : b.hi[i] < 0 ? b.hi[i] : Exact(0));
  return sum;
}

} // namespace lightcuts::precise
