// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/truth.h>

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace lightcuts::oracle {
namespace {

constexpr long double pi = 3.141592653589793238462643383279502884L;

Exact dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += Exact(n[i]) * (Exact(y[i]) - Exact(x[i]));
  return sum;
}

/// n.(y - x) to a few ulps: six exact products summed twice as accurately (Ogita, Rump & Oishi
/// 2005, "Accurate sum and dot product"), or in 700 bits where even that cancels.
long double accurate_dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  long double sum = 0;
  long double lost = 0;
  long double magnitude = 0;
  for (int i = 0; i < 3; ++i)
    for (const float v : {y[i], -x[i]}) {
      const long double term = static_cast<long double>(n[i]) * v; // 48 bits
      const long double next = sum + term;
      const long double seen = next - sum;
      lost += (sum - (next - seen)) + (term - seen);
      sum = next;
      magnitude += std::abs(term);
    }
  const long double result = sum + lost;
  // The second order error is below 36 eps^2 magnitude: relative eps needs 64 eps of it left.
  constexpr long double eps = std::numeric_limits<long double>::epsilon();
  if (magnitude == 0 || std::abs(result) >= 64 * eps * magnitude) return result;
  return dot(n, x, y).convert_to<long double>();
}

long double length(const glm::vec3& v) {
  const long double x = v.x;
  const long double y = v.y;
  const long double z = v.z;
  return std::sqrt(x * x + y * y + z * z);
}

Exact exact_squared_length(const glm::vec3& v, const glm::vec3& from) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact q = Exact(v[i]) - Exact(from[i]);
    sum += q * q;
  }
  return sum;
}

} // namespace

Wide contribution(const OmniLight& light, const ShadingPoint& point) {
  const glm::vec3& x = point.position();
  const glm::vec3& y = light.position;
  const long double n_dot_q = accurate_dot(point.normal(), x, y);
  if (n_dot_q <= 0) return {};
  long double distance2 = 0;
  for (int i = 0; i < 3; ++i) {
    const long double q = static_cast<long double>(y[i]) - x[i];
    distance2 += q * q;
  }
  const long double distance = std::sqrt(distance2);
  const long double geometric = n_dot_q / length(point.normal()) / distance / distance2;
  const Material& m = point.material();
  long double lobe = 0;
  if (m.has_specular()) {
    const long double cosine =
        accurate_dot(point.mirror(), x, y) / (length(point.mirror()) * distance);
    if (cosine > 0)
      lobe = (static_cast<long double>(m.exponent) + 2) / (2 * pi) *
             std::pow(cosine, static_cast<long double>(m.exponent));
  }
  Wide result;
  for (int c = 0; c < 3; ++c)
    result[c] = (m.diffuse[c] / pi + m.specular[c] * lobe) * geometric * light.intensity[c];
  return result;
}

Exact exact_contribution(const OmniLight& light, const ShadingPoint& point, int channel) {
  const glm::vec3& x = point.position();
  const glm::vec3& y = light.position;
  const glm::vec3 origin(0);
  const Exact n_dot_q = dot(point.normal(), x, y);
  if (n_dot_q <= 0) return 0;
  const Exact distance2 = exact_squared_length(y, x);
  const Exact normal2 = exact_squared_length(point.normal(), origin);
  const Exact geometric = n_dot_q / (sqrt(normal2 * distance2) * distance2);
  const Material& m = point.material();
  const Exact& exact_pi = boost::math::constants::pi<Exact>();
  Exact brdf = m.diffuse[channel] / exact_pi;
  const Exact r_dot_q = dot(point.mirror(), x, y);
  if (m.specular[channel] > 0 && r_dot_q > 0) {
    const Exact mirror2 = exact_squared_length(point.mirror(), origin);
    const Exact cosine = r_dot_q / sqrt(mirror2 * distance2);
    brdf += m.specular[channel] * (Exact(m.exponent) + 2) / (2 * exact_pi) *
            pow(cosine, Exact(m.exponent));
  }
  return brdf * geometric * light.intensity[channel];
}

void Truth::evaluate(const LightTree& tree, const ShadingPoint& point,
                     std::span<const char> visible) {
  tree_ = &tree;
  point_ = &point;
  visible_ = visible;
  const auto nodes = tree.nodes();
  open_.resize(nodes.size());
  seen_.resize(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    if (node.is_leaf()) {
      open_[i] = contribution(tree.lights()[node.representative], point);
      seen_[i] = visible[node.representative] != 0 ? open_[i] : Wide{};
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      open_[i][c] = open_[node.first_child][c] + open_[node.first_child + 1][c];
      seen_[i][c] = seen_[node.first_child][c] + seen_[node.first_child + 1][c];
    }
  }
}

Exact Truth::exact(std::uint32_t node, int channel, bool only_visible) const {
  Exact sum = 0;
  std::vector<std::uint32_t> open{node};
  while (!open.empty()) {
    const TreeNode& n = tree_->node(open.back());
    open.pop_back();
    if (!n.is_leaf()) {
      open.push_back(n.first_child);
      open.push_back(n.first_child + 1);
    } else if (!only_visible || visible_[n.representative] != 0) {
      sum += exact_contribution(tree_->lights()[n.representative], *point_, channel);
    }
  }
  return sum;
}

} // namespace lightcuts::oracle
