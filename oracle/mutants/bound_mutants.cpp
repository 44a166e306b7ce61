// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include <lightcuts/core/kernels/cluster_estimate.h>
#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

using Library = AnySuprema;

constexpr double inf = std::numeric_limits<double>::infinity();

glm::dvec3 to(const glm::vec3& from, const glm::vec3& y) {
  return glm::dvec3(y) - glm::dvec3(from);
}

/// max(0, n.q)/|q|, n as it is.
double cosine(const glm::vec3& n, const glm::dvec3& q) {
  return std::max(0.0, glm::dot(glm::dvec3(n), q) / glm::length(q));
}

glm::vec3 centre(const Box& box) {
  return glm::vec3(0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi)));
}

glm::vec3 corner(const Box& box, int bits) {
  return {bits & 1 ? box.hi.x : box.lo.x, bits & 2 ? box.hi.y : box.lo.y,
          bits & 4 ? box.hi.z : box.lo.z};
}

// ---- the cosine of the surface

struct CosineOfTwoCorners : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    return std::max(cosine(n, to(from, box.lo)), cosine(n, to(from, box.hi))) *
           max_falloff(kind, from, box, d2);
  }
};

struct CosineOfCornersOnly : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    double most = 0;
    for (int i = 0; i < 8; ++i) most = std::max(most, cosine(n, to(from, corner(box, i))));
    return most == 0 ? 0 : most * max_falloff(kind, from, box, d2);
  }
};

struct CosineOfCentre : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const double at_centre = cosine(n, to(from, centre(box)));
    return at_centre == 0 ? 0 : at_centre * max_falloff(kind, from, box, d2);
  }
};

struct PoleNormal : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    // Of the rotation that turns n to +z: of unit length, or 0/0.
    const glm::dvec3 axis = glm::normalize(glm::cross(glm::dvec3(n), glm::dvec3(0, 0, 1)));
    return Library::max_cosine_falloff(kind, n, from, box, d2) * glm::dot(axis, axis);
  }
};

struct CosineNotShaded : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const double max_cosine_falloff = Library::max_cosine_falloff(kind, n, from, box, d2);
    return max_cosine_falloff == 0
               ? 0
               : max_cosine_falloff * max_cosine(n, from, box); // once too often
  }
};

// ---- the distance

/// n.l and the falloff apart, the latter by another squared distance.
template <double squared_distance(const glm::vec3& from, const Box& box)>
struct ByDistance : Library {
  double max_falloff(LightKind kind, const glm::vec3& from, const Box& box,
                     double d2) const override {
    if (kind == LightKind::directional) return 1;
    return 1 / std::max(squared_distance(from, box), d2);
  }
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const double most = max_cosine(n, from, box);
    return most == 0 ? 0 : most * max_falloff(kind, from, box, d2);
  }
};

double to_centre(const glm::vec3& from, const Box& box) {
  const glm::dvec3 q = to(from, centre(box));
  return glm::dot(q, q);
}

double unsquared(const glm::vec3& from, const Box& box) {
  return std::max(min_distance2(from, box), std::sqrt(squared_diagonal_of_union(box, box)));
}

double to_farthest(const glm::vec3& from, const Box& box) {
  double most = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 q = to(from, corner(box, i));
    most = std::max(most, glm::dot(q, q));
  }
  return most;
}

double near_is_inside(const glm::vec3& from, const Box& box) {
  const double nearest2 = min_distance2(from, box);
  return nearest2 < 0.01 ? 0 : nearest2;
}

double slab_is_inside(const glm::vec3& from, const Box& box) {
  for (int i = 0; i < 3; ++i)
    if (box.lo[i] < from[i] && from[i] < box.hi[i]) return 0;
  return min_distance2(from, box);
}

double inside_is_finite(const glm::vec3& from, const Box& box) {
  const double nearest2 = min_distance2(from, box);
  return nearest2 == 0 ? 0.25 * squared_diagonal_of_union(box, box) : nearest2;
}

struct ZeroTimesInfinity : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    return max_cosine(n, from, box) * max_falloff(kind, from, box, d2);
  }
};

struct ClampMismatch : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    return Library::max_cosine_falloff(kind, n, from, box, std::sqrt(d2)); // d_min for d_min^2
  }
  double max_falloff(LightKind kind, const glm::vec3& from, const Box& box,
                     double d2) const override {
    return Library::max_falloff(kind, from, box, std::sqrt(d2));
  }
};

struct BoundRoundedDown : Library {
  // A box stored in steps of 1/256 of its size, its corners rounded to the nearest one inside.
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const glm::vec3 step = (box.hi - box.lo) / 256.0F;
    return Library::max_cosine_falloff(kind, n, from, {box.lo + step, box.hi - step}, d2);
  }
};

// ---- lobes

/// The library's bounds by other lobes: altered<OneLobe>, made of the point's.
template <template <class> class Altered>
struct BoundedByLobe : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return std::visit(
        [&]<class OneLobe>(const OneLobe& lobe) {
          if constexpr (std::is_same_v<OneLobe, NoLobe>)
            return contribution_bound(tree, node, point);
          else
            return bound_over_kinds(tree, node, [&](std::uint32_t i) {
              return cluster_bound(Library(), tree, i, point, Altered<OneLobe>{lobe});
            });
        },
        point.material().lobe);
  }
};

template <class OneLobe>
struct BoundedByHalfTheCone : OneLobe {
  /// Least angle between n and h, were h to turn by half as much as l.
  static double tangent2(const BoxSight& box) {
    const auto direction = [&](const glm::vec3& y) { return glm::normalize(to(box.from, y)); };
    const glm::dvec3 l = direction(centre(box.box));
    const glm::dvec3 h = l + glm::dvec3(box.frame.to_viewer());
    Angle cone;
    for (int i = 0; i < 8; ++i) {
      const Angle angle = angle_between(l, direction(corner(box.box, i)));
      if (angle.cos < cone.cos) cone = angle;
    }
    const Angle least = difference(angle_between(glm::dvec3(box.frame.normal()), h), half(cone));
    return least.cos <= 0 ? inf : least.sin * least.sin / (least.cos * least.cos);
  }
  [[nodiscard]] glm::dvec3 bound(const BoxSight& box) const {
    const double viewer = box.frame.viewer_cosine();
    if (viewer <= 0) return glm::dvec3(0);
    if constexpr (std::is_same_v<OneLobe, Ward>) {
      const double a2 = double(this->alpha) * this->alpha;
      return lobe_bound(this->reflectance, std::exp(-tangent2(box) / a2) * this->peak(viewer) *
                                               std::sqrt(box.max_cosine_falloff * box.max_falloff));
    } else if constexpr (std::is_same_v<OneLobe, CookTorrance>) {
      return glm::dvec3(1) * (this->distribution(tangent2(box)) * this->visibility(0, viewer) *
                              box.max_cosine_falloff);
    } else {
      return OneLobe::bound(box);
    }
  }
};

template <class OneLobe>
struct BoundedAtNormal : OneLobe {
  [[nodiscard]] glm::dvec3 bound(const BoxSight& box) const {
    const glm::vec3 overhead = box.frame.position() + box.frame.normal();
    return this->evaluate(Sight(box.frame, LightKind::omni, overhead)) * box.max_cosine_falloff;
  }
};

template <class OneLobe>
struct NotBounded : OneLobe {
  [[nodiscard]] glm::dvec3 bound(const BoxSight& /*box*/) const { return glm::dvec3(0); }
};

struct SignedPhong : Phong {
  [[nodiscard]] glm::dvec3 evaluate(const Sight& sight) const {
    const double cosine = sight.mirror_cosine();
    if (cosine < 0 && std::fmod(exponent, 2) == 1)
      return glm::dvec3(reflectance) * (normalisation() * std::pow(cosine, double(exponent)));
    return Phong::evaluate(sight);
  }
};

struct SignedSpecular : LibraryKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    const auto* phong = std::get_if<Phong>(&point.material().lobe);
    if (phong == nullptr) return LibraryKernel::estimate(tree, node, point, bound);
    const glm::dvec3 e = over_kinds(tree, node, [&](std::uint32_t i) {
      return visit_kind(tree.node(i).kind(), [&]<class Kind>(Kind) {
        return centroid_estimate<Kind>(tree, i, point, SignedPhong{*phong});
      });
    });
    return tree.node(node).is_leaf() ? e : glm::min(e, glm::dvec3(bound));
  }
};

// ---- orientation cones

double emission_bound(LightKind kind, const ClusterEmission& e, const glm::vec3& from,
                      const Box& box) {
  return visit_kind(
      kind, [&]<class Kind>(Kind) { return Kind::max_emission(e, DifferenceBox(from, box)); });
}

double radians(const Angle& angle) { return std::atan2(angle.sin, angle.cos); }

OrientationCone cone_of(const glm::vec3& axis, double half_angle) {
  return {axis, float(2 - 2 * std::cos(half_angle))};
}

/// Emission by other cones: altered(tree, i), made of the node's children.
template <OrientationCone altered(const LightTree& tree, std::uint32_t i)>
struct ByCone : Library {
  double max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                      const glm::vec3& from) const override {
    ClusterEmission e = tree.emission(i);
    e.cone = altered(tree, i);
    return emission_bound(kind, e, from, tree.node(i).box);
  }
};

OrientationCone gap_of_a_degree(const LightTree& tree, std::uint32_t i) {
  const OrientationCone& cone = tree.emission(i).cone;
  if (tree.node(i).is_leaf()) return cone;
  return cone_of(cone.axis, std::max(0.0, radians(cone.half_angle()) - std::numbers::pi / 180));
}

OrientationCone acos_unclamped(const LightTree& tree, std::uint32_t i) {
  const std::uint32_t child = tree.node(i).first_child;
  OrientationCone cone = tree.emission(i).cone;
  if (child == 0) return cone;
  const float cosine = glm::dot(tree.emission(child).cone.axis, tree.emission(child + 1).cone.axis);
  cone.chord2 += 0 * std::acos(cosine); // more than 1 for some equal axes
  return cone;
}

OrientationCone wrapped(const LightTree& tree, std::uint32_t i) {
  const std::uint32_t child = tree.node(i).first_child;
  if (child == 0) return tree.emission(i).cone;
  const OrientationCone &a = tree.emission(child).cone, &b = tree.emission(child + 1).cone;
  const double between = radians(angle_between(glm::dvec3(a.axis), glm::dvec3(b.axis)));
  const double half_angle =
      std::max(radians(a.half_angle()), between + radians(b.half_angle())) + 1e-6;
  return cone_of(a.axis, std::fmod(half_angle, std::numbers::pi));
}

OrientationCone opposite(const LightTree& tree, std::uint32_t i) {
  OrientationCone cone = tree.emission(i).cone;
  cone.axis = -cone.axis;
  return cone;
}

// ---- intensities

/// The library's bound with another intensity of the cluster.
template <glm::dvec3 intensity_of(const LightTree& tree, const TreeNode& cluster)>
struct ByIntensity : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    const TreeNode& cluster = tree.node(node);
    const glm::dvec3 intensity = intensity_of(tree, cluster);
    const glm::vec3 bound = LibraryKernel::bound(tree, node, point);
    glm::vec3 result(0);
    for (int c = 0; c < 3; ++c)
      if (cluster.intensity[c] > 0)
        result[c] = to_float(bound[c] * (intensity[c] / cluster.intensity[c]));
    return result;
  }
};

glm::dvec3 of_representative(const LightTree& tree, const TreeNode& cluster) {
  return tree.lights()[cluster.representative].intensity;
}

glm::dvec3 luminance(const LightTree& /*tree*/, const TreeNode& cluster) {
  return glm::dvec3(glm::dot(cluster.intensity, glm::dvec3(0.2126, 0.7152, 0.0722)));
}

constexpr Mutant bound_catalogue[] = {
    {"cosine-of-two-corners", "bounds n.l by two of the box's eight corners",
     with_suprema<CosineOfTwoCorners>},
    {"cosine-of-corners-only", "bounds n.l by the eight corners, without edges and faces",
     with_suprema<CosineOfCornersOnly>},
    {"cosine-of-centre", "bounds n.l by the box's centre", with_suprema<CosineOfCentre>},
    {"pole-normal", "turns the normal to +z by an axis that is 0/0 where it is +z already",
     with_suprema<PoleNormal>},
    {"distance-to-centre", "bounds 1/d^2 by the box's centre", with_suprema<ByDistance<to_centre>>},
    {"distance-unsquared", "clamps d^2 by the box's diagonal, a length",
     with_suprema<ByDistance<unsquared>>},
    {"distance-farthest", "bounds 1/d^2 by the farthest corner",
     with_suprema<ByDistance<to_farthest>>},
    {"absolute-epsilon", "counts d^2 < 0.01 as inside the box, whatever the unit of length",
     with_suprema<ByDistance<near_is_inside>>},
    {"slab-is-inside", "counts a point between two faces as inside the box: valid, but infinite",
     with_suprema<ByDistance<slab_is_inside>>},
    {"inside-is-finite", "bounds 1/d^2 by the box's size where the point is inside",
     with_suprema<ByDistance<inside_is_finite>>},
    {"half-vector-half-angle", "lets the half vector turn by half the cone of the lights",
     with_kernel<BoundedByLobe<BoundedByHalfTheCone>>},
    {"specular-at-normal", "bounds a lobe by its value for light along the normal",
     with_kernel<BoundedByLobe<BoundedAtNormal>>},
    {"specular-missing", "leaves the lobe out of the bound",
     with_kernel<BoundedByLobe<NotBounded>>},
    {"diffuse-cosine-not-shaded", "has a cosine in the bound that shading has not",
     with_suprema<CosineNotShaded>},
    {"signed-specular", "raises negative cosines to odd powers", with_kernel<SignedSpecular>},
    {"cone-merge-gap", "loses a degree of the cone where two are merged",
     with_suprema<ByCone<gap_of_a_degree>>},
    {"cone-acos-unclamped", "takes the arc cosine of more than 1 where axes are merged",
     with_suprema<ByCone<acos_unclamped>>},
    {"cone-wrap", "lets half-angles beyond 180 degrees start again at 0",
     with_suprema<ByCone<wrapped>>},
    {"cone-sign", "tests cones against the direction towards the light",
     with_suprema<ByCone<opposite>>},
    {"intensity-of-representative", "bounds by the representative's intensity, not the cluster's",
     with_kernel<ByIntensity<of_representative>>},
    {"intensity-scalar", "bounds all channels by the cluster's luminance",
     with_kernel<ByIntensity<luminance>>},
    {"bound-rounded-down", "stores boxes in steps, their corners rounded inwards",
     with_suprema<BoundRoundedDown>},
    {"zero-times-infinity", "multiplies a cosine of 0 by a falloff of infinity",
     with_suprema<ZeroTimesInfinity>},
    {"clamp-mismatch", "clamps d^2 by the least distance in the bound, by its square in shading",
     with_suprema<ClampMismatch>},
};

} // namespace

std::span<const Mutant> bound_mutants() { return bound_catalogue; }

} // namespace lightcuts::oracle
