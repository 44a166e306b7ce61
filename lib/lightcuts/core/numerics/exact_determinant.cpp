// SPDX-License-Identifier: MIT
#include <lightcuts/core/numerics/exact_determinant.h>

#include <lightcuts/core/numerics/expansion.h>

namespace lightcuts {

double exact_determinant(const glm::vec3& a, const glm::vec3& x, const glm::vec3& y,
                         const glm::vec3& b) {
  // Products of two floats are exact in double; of three, no bit is below 2^-447.
  Expansion<24> sum; // 3 x 2 x 2 products, of two terms each
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (const double part : {double(b[j]) * a[k], -double(b[k]) * a[j]}) { // of b x a
      sum.add_product(part, y[i]);
      sum.add_product(part, -x[i]);
    }
  }
  return sum.rounded();
}

} // namespace lightcuts
