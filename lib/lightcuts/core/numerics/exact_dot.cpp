// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/exact_dot.h>

#include <lightcuts/core/numerics/expansion.h>

namespace lightcuts {

double exact_dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  // Products of two floats have 48 bits and lie in [2^-298, 2^256]: exact in double.
  Expansion<6> sum;
  for (int i = 0; i < 3; ++i) {
    sum.add(double(n[i]) * double(y[i]));
    sum.add(-double(n[i]) * double(x[i]));
  }
  return sum.rounded();
}

} // namespace lightcuts
