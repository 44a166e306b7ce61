// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_emission.h>

#include <unordered_map>
#include <utility>

#include <glm/common.hpp>

#include <lightcuts/core/lights/profile_envelope.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {
namespace {

ClusterEmission of_light(const Light& light) {
  const glm::dvec3 a = glm::normalize(glm::dvec3(light.axis));
  return {.cone = {light.axis, 0},
          .mean_axis = glm::vec3(a),
          .axis_square = glm::vec3(a * a),
          .axis_product = glm::vec3(a.y * a.z, a.z * a.x, a.x * a.y),
          .cos_inner = light.cos_inner,
          .cos_outer = light.cos_outer};
}

double weight(const TreeNode& node) {
  return node.intensity.x + node.intensity.y + node.intensity.z;
}

/// Profiles of leaves and of what is made of them, each kept once where many lights share it.
class ClusterProfiles {
public:
  std::shared_ptr<const ClusterProfile> of_light(const Light& light) {
    if (last_ == nullptr || !last_->profile.is_same_object(light.profile) ||
        last_->plane != light.plane)
      last_ = std::make_shared<ClusterProfile>(
          ClusterProfile{light.profile, envelope(light.profile), light.plane, true});
    return last_;
  }

  /// Of a cluster, about `axes`, and its children.
  static std::shared_ptr<const ClusterProfile>
  merged(const OrientationCone& axes, const ClusterEmission& a, const ClusterEmission& b) {
    if (a.profile == nullptr) return nullptr;
    const ClusterProfile &p = *a.profile, &q = *b.profile;
    if (axes.chord2 == 0 && a.cone.axis == b.cone.axis && p.one_frame && q.one_frame &&
        p.plane == q.plane && p.profile == q.profile)
      return a.profile;
    Profile both = united(p.envelope, q.envelope);
    if (!p.one_frame && both.is_same_object(p.envelope)) return a.profile;
    if (!q.one_frame && both.is_same_object(q.envelope)) return b.profile;
    return std::make_shared<ClusterProfile>(ClusterProfile{{}, std::move(both), {}, false});
  }

private:
  const Profile& envelope(const Profile& profile) {
    const auto [known, is_new] = envelopes_.try_emplace(&profile.table());
    if (is_new) known->second = envelope_of(profile);
    return known->second;
  }

  std::unordered_map<const ProfileTable*, Profile> envelopes_;
  std::shared_ptr<const ClusterProfile> last_;
};

} // namespace

std::vector<ClusterEmission> emission_of(std::span<const TreeNode> nodes, const LightSet& lights) {
  std::vector<ClusterEmission> result(nodes.size());
  ClusterProfiles profiles;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    if ((node.kinds & kinds_with_axis) == 0 || node.is_mixed()) continue;
    if (node.is_leaf()) {
      const Light& light = lights[node.representative];
      result[i] = of_light(light);
      if (light.kind == LightKind::profile) result[i].profile = profiles.of_light(light);
      continue;
    }
    const std::uint32_t a = node.first_child, b = a + 1;
    const double sum = weight(nodes[a]) + weight(nodes[b]);
    const double share = sum > 0 ? weight(nodes[b]) / sum : 0.5;
    const auto mean = [&](glm::vec3 ClusterEmission::*part) {
      return glm::vec3(glm::mix(glm::dvec3(result[a].*part), glm::dvec3(result[b].*part), share));
    };
    result[i] = {.cone = merged(result[a].cone, result[b].cone),
                 .mean_axis = mean(&ClusterEmission::mean_axis),
                 .axis_square = mean(&ClusterEmission::axis_square),
                 .axis_product = mean(&ClusterEmission::axis_product),
                 .cos_inner = std::min(result[a].cos_inner, result[b].cos_inner),
                 .cos_outer = std::min(result[a].cos_outer, result[b].cos_outer)};
    result[i].profile = ClusterProfiles::merged(result[i].cone, result[a], result[b]);
  }
  return result;
}

} // namespace lightcuts
