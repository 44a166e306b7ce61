// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/rim_distance.h>

#include <lightcuts/core/numerics/expansion.h>

namespace lightcuts::detail {

// With p = a.d, L = |a| |d| and c = rim: p/L - c = (p^2 - c^2 L^2) / (L (p + c L)), of which
// only the numerator cancels. It is a sum of products of six floats: no bit is below 2^-894.
double exact_rim_distance(const glm::vec3& axis, const glm::vec3& position, const glm::vec3& x,
                          float rim) {
  const glm::vec3 &a = axis, &y = position;
  Expansion<6> p;
  Expansion<3> axis2;
  Expansion<9> distance2;
  for (int i = 0; i < 3; ++i) {
    p.add(double(a[i]) * x[i]);
    p.add(-double(a[i]) * y[i]);
    axis2.add(double(a[i]) * a[i]);
    distance2.add(double(x[i]) * x[i]);
    distance2.add(-2 * (double(x[i]) * y[i]));
    distance2.add(double(y[i]) * y[i]);
  }
  Expansion<2 * 3 * 9> length2;
  for (const double u : axis2.terms())
    for (const double v : distance2.terms()) length2.add_product(u, v);
  Expansion<2 * 6 * 6 + 2 * 2 * 3 * 9> numerator;
  for (const double u : p.terms())
    for (const double v : p.terms()) numerator.add_product(u, v);
  const double c = rim;
  for (const double u : length2.terms()) numerator.add_product(-c * c, u);
  const double length = std::sqrt(length2.rounded());
  return numerator.rounded() / (length * (p.rounded() + c * length));
}

} // namespace lightcuts::detail
