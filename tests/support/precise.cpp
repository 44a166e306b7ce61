// SPDX-License-Identifier: MIT
#include <tests/support/precise.h>

#include <boost/math/constants/constants.hpp>

#include <oracle/truth/radiometry.h>

namespace lightcuts::precise {

Exact dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += Exact(n[i]) * (Exact(y[i]) - Exact(x[i]));
  return sum;
}

Exact distance2(const glm::vec3& x, const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += square(Exact(y[i]) - Exact(x[i]));
  return sum;
}

Quad length(const glm::vec3& v) { return sqrt(Quad(distance2(glm::vec3(0), v))); }

Quad power(Quad base, float exponent) {
  auto whole = static_cast<std::uint32_t>(exponent);
  const float fraction = exponent - static_cast<float>(whole);
  Quad result = fraction == 0 ? Quad(1) : base == 0 ? Quad(0) : Quad(pow(base, Quad(fraction)));
  for (; whole != 0; whole >>= 1, base *= base)
    if ((whole & 1U) != 0) result *= base;
  return result;
}

Quad pi() { return boost::math::constants::pi<Quad>(); }

Colour contribution(const ShadingPoint& point, const Light& light, float min_distance) {
  return oracle::radiometry::contribution<Quad>(light, point, min_distance);
}

Colour transfer(const ShadingPoint& point, const glm::vec3& y) {
  return contribution(point, {.position = y, .intensity = glm::vec3(1)});
}

Colour sum(const LightSet& lights, const ShadingPoint& point,
           const std::function<bool(std::uint32_t)>& visible) {
  Colour total{};
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (!visible(i)) continue;
    const Colour one = contribution(point, lights[i], lights.min_distance());
    for (int c = 0; c < 3; ++c) total[c] += one[c];
  }
  return total;
}

std::vector<Colour> contributions(const LightTree& tree, const ShadingPoint& point) {
  std::vector<Colour> result(tree.nodes().size());
  for (std::size_t i = result.size(); i-- > 0;) {
    const TreeNode& node = tree.nodes()[i];
    if (node.is_leaf()) {
      result[i] =
          contribution(point, tree.lights()[node.representative], tree.lights().min_distance());
      continue;
    }
    for (int c = 0; c < 3; ++c)
      result[i][c] = result[node.first_child][c] + result[node.first_child + 1][c];
  }
  return result;
}

} // namespace lightcuts::precise
