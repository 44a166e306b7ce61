// SPDX-License-Identifier: MIT
#include <lightcuts/core/shading/sight.h>

#include <lightcuts/core/numerics/exact_determinant.h>

namespace lightcuts {

// With s_l = |n x l|, s_v = |n x v| and phi the angle between l_t and v_t, which is obtuse,
//   |l_t + v_t|^2 = (s_l - s_v)^2 + 2 s_l s_v (1 + cos phi) ,
//   s_l - s_v = (n.v - n.l) (n.v + n.l) / (s_l + s_v) ,
//   1 + cos phi = sin^2 phi / (1 - cos phi) ,  s_l s_v sin phi = det(n, l, v) ,
// so that n.l + n.v divides out of the first term, and in the second two numbers are divided that
// are known to the last digits, however small. s_l s_v cos phi is l.v - n.l n.v.
double Sight::half_tangent2_of_opposites(double sum2) const {
  const glm::vec3 &n = frame_.normal(), &o = frame_.to_viewer();
  const double per_n = frame_.inverse_normal_length(), per_o = frame_.inverse_viewer_length();
  const double light = dot_between<8>(n, from_, to_) * per_n / distance_;
  const double viewer = dot_between<8>(n, glm::vec3(0), o) * per_n * per_o;
  const double sine = determinant_between(n, from_, to_, o) * per_n * per_o / distance_;
  const double up = light + viewer;
  const double light_sine = std::sqrt(1 - light * light);
  const double viewer_sine = std::sqrt(1 - viewer * viewer);
  const double between_cosine = 0.5 * sum2 - 1;
  const double in_plane = (light - viewer) / (light_sine + viewer_sine);
  const double aside = sine / up; // below 2^299: its square does not overflow
  return in_plane * in_plane +
         2 * aside * aside / (light_sine * viewer_sine - between_cosine + light * viewer);
}

} // namespace lightcuts
