// SPDX-License-Identifier: MIT
#include <oracle/truth/fast_truth.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <oracle/truth/radiometry.h>

namespace lightcuts::oracle {
namespace {

/// Lights at a time: what is computed of them stays in the nearest cache.
constexpr std::size_t block = 128;
/// Cancellation in n.q up to which the plain sum will do.
constexpr double least_left = 0x1p-10;

std::vector<FastNode> nodes_of(const LightTree& tree) {
  std::vector<FastNode> nodes;
  nodes.reserve(tree.nodes().size());
  for (const TreeNode& n : tree.nodes()) {
    if (n.is_leaf())
      nodes.push_back({n.representative, FastNode::no_child});
    else
      nodes.push_back({n.first_child, n.first_child + 1});
  }
  return nodes;
}

std::uint32_t height_of(std::span<const FastNode> nodes) {
  std::vector<std::uint32_t> height(nodes.size(), 0);
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (nodes[i].other != FastNode::no_child)
      height[i] = 1 + std::max(height[nodes[i].child], height[nodes[i].other]);
  return nodes.empty() ? 0 : height[0];
}

} // namespace

bool FastTruth::supports(std::span<const Light> lights, const Material& material) {
  return std::holds_alternative<NoLobe>(material.lobe) &&
         std::all_of(lights.begin(), lights.end(),
                     [](const Light& l) { return l.kind == LightKind::omni; });
}

FastTruth::FastTruth(std::span<const Light> lights, std::span<const FastNode> nodes,
                     float min_distance)
    : min_distance2_(double(min_distance) * min_distance),
      error_(0x1p-40 + height_of(nodes) * 0x1p-52), sums_(nodes.size()) {
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const FastNode& n = nodes[i];
    if (n.other != FastNode::no_child) {
      assert(n.child > i && n.other > i);
      inner_.push_back({std::uint32_t(i), n.child, n.other});
      continue;
    }
    const Light& light = lights[n.child];
    assert(light.kind == LightKind::omni);
    x_.push_back(light.position.x);
    y_.push_back(light.position.y);
    z_.push_back(light.position.z);
    intensity_.push_back({light.intensity.x, light.intensity.y, light.intensity.z});
    leaves_.push_back(std::uint32_t(i));
  }
  transfer_.resize(leaves_.size());
}

FastTruth::FastTruth(const LightTree& tree)
    : FastTruth(std::span(tree.lights().begin(), tree.lights().end()), nodes_of(tree),
                tree.lights().min_distance()) {}

void FastTruth::evaluate(const ShadingPoint& point) {
  assert(std::holds_alternative<NoLobe>(point.material().lobe));
  const glm::dvec3 n(point.normal());
  const double scale = std::numbers::inv_pi / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  for (std::size_t c = 0; c < 3; ++c) {
    to_upper_[c] = point.material().diffuse[int(c)] * scale * (1 + error_);
    to_lower_[c] = point.material().diffuse[int(c)] * scale * (1 - error_);
  }
  for (std::size_t begin = 0; begin < leaves_.size(); begin += block)
    evaluate_block(point, begin, std::min(begin + block, leaves_.size()));
  for (const Inner& i : inner_)
    for (std::size_t c = 0; c < 4; ++c) sums_[i.node][c] = sums_[i.child][c] + sums_[i.other][c];
}

void FastTruth::evaluate_block(const ShadingPoint& point, std::size_t begin, std::size_t end) {
  const glm::dvec3 n(point.normal()), x(point.position());
  const double least2 = min_distance2_;
  double cancelled = -1;
  for (std::size_t j = begin; j < end; ++j) {
    const double qx = double(x_[j]) - x.x, qy = double(y_[j]) - x.y, qz = double(z_[j]) - x.z;
    const double a = n.x * qx, b = n.y * qy, c = n.z * qz;
    const double n_dot_q = a + b + c;
    const double magnitude = std::abs(a) + std::abs(b) + std::abs(c);
    const double short_of = least_left * magnitude - std::abs(n_dot_q);
    cancelled = cancelled > short_of ? cancelled : short_of;
    const double distance2 = qx * qx + qy * qy + qz * qz;
    const double clamped2 = distance2 > least2 ? distance2 : least2;
    const double transfer = n_dot_q / (std::sqrt(distance2) * clamped2);
    transfer_[j] = n_dot_q > 0 ? transfer : 0; // 0/0 where the light is at the point
  }
  if (cancelled > 0) [[unlikely]]
    evaluate_doubtful(point, begin, end);
  for (std::size_t j = begin; j < end; ++j) {
    Sum& sum = sums_[leaves_[j]];
    for (std::size_t c = 0; c < 3; ++c) sum[c] = intensity_[j][c] * transfer_[j];
  }
}

/// Anew, those of the block whose n.q cancelled.
void FastTruth::evaluate_doubtful(const ShadingPoint& point, std::size_t begin, std::size_t end) {
  const glm::dvec3 n(point.normal());
  for (std::size_t j = begin; j < end; ++j) {
    const glm::vec3 y(x_[j], y_[j], z_[j]);
    const glm::dvec3 q = glm::dvec3(y) - glm::dvec3(point.position());
    const double plain = n.x * q.x + n.y * q.y + n.z * q.z;
    const double magnitude = std::abs(n.x * q.x) + std::abs(n.y * q.y) + std::abs(n.z * q.z);
    if (!(least_left * magnitude > std::abs(plain))) continue;
    const auto n_dot_q =
        double(radiometry::dot_between<long double>(point.normal(), point.position(), y));
    const double distance2 = q.x * q.x + q.y * q.y + q.z * q.z;
    transfer_[j] =
        n_dot_q > 0 ? n_dot_q / (std::sqrt(distance2) * std::max(distance2, min_distance2_)) : 0;
  }
}

void compare(std::span<const glm::vec3> bounds, const FastTruth& truth, FastComparison& result) {
  assert(bounds.size() == truth.size());
  result = {.undecided = std::move(result.undecided)};
  result.undecided.clear();
  // One test for both questions: as long as the largest ratio is at most 1, a node that does not
  // exceed it holds. Rounding of the product is monotone.
  double worst = 0;
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    const glm::vec3& bound = bounds[i];
    if (truth.upper(i, 0) <= worst * bound.x && truth.upper(i, 1) <= worst * bound.y &&
        truth.upper(i, 2) <= worst * bound.z) [[likely]]
      continue;
    bool decided = true;
    for (int c = 0; c < 3; ++c) decided = decided && bound[c] >= truth.upper(i, c);
    if (!decided) {
      result.undecided.push_back(i);
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      if (!(truth.upper(i, c) > worst * bound[c])) continue; // +inf, too
      worst = truth.upper(i, c) / bound[c];
      result.worst_node = i;
      result.worst_channel = c;
    }
  }
  result.worst_ratio = worst;
}

} // namespace lightcuts::oracle
