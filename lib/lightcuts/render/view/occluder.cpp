// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/occluder.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include <embree3/rtcore.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float largest_component(const glm::vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The power of two that scales v to a largest component in [1, 2); 1 for the zero vector.
double unit_scale(const glm::vec3& v) {
  const float largest = largest_component(v);
  // By the bits of a normal number's exponent: the functions cost a tenth of a ray.
  const std::uint32_t exponent = std::bit_cast<std::uint32_t>(largest) >> 23;
  if (exponent != 0) [[likely]]
    return std::bit_cast<double>(std::uint64_t(1023 + 127 - exponent) << 52);
  return largest > 0 ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
}

// Exact for powers of two, but where the result is subnormal.
glm::vec3 scaled(const glm::vec3& v, double factor) { return glm::vec3(glm::dvec3(v) * factor); }

// Embree's debug checks end the process beyond 2^60; NaN fails this comparison, too.
bool is_near(const glm::vec3& scaled_origin) { return largest_component(scaled_origin) <= 0x1p59F; }

void validate(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!is_finite(mesh.positions[i]))
      throw InputError(InputFault::not_finite,
                       "mesh: position " + std::to_string(i) + " is not finite");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (mesh.triangles[i][k] >= mesh.positions.size())
        throw InputError(InputFault::inconsistent,
                         "mesh: triangle " + std::to_string(i) + " has an index out of range");
}

RTCRay embree_ray(const glm::vec3& origin, const glm::vec3& direction, float far) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tfar = far;
  ray.mask = ~0U;
  return ray;
}

} // namespace

// Its plane is lost in rounding: the cross product of two edges carries a few
// roundings of 2^-53 relative to the product of their lengths.
bool blocks_nothing(const TriangleMesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a = glm::dvec3(mesh.positions[t.y]) - glm::dvec3(mesh.positions[t.x]);
  const glm::dvec3 b = glm::dvec3(mesh.positions[t.z]) - glm::dvec3(mesh.positions[t.x]);
  return glm::length(glm::cross(a, b)) <= 0x1p-48 * glm::length(a) * glm::length(b);
}

struct Occluder::Embree {
  struct Release {
    void operator()(RTCDevice handle) const { rtcReleaseDevice(handle); }
    void operator()(RTCScene handle) const { rtcReleaseScene(handle); }
    void operator()(RTCGeometry handle) const { rtcReleaseGeometry(handle); }
  };
  template <typename Handle>
  using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

  Owner<RTCDevice> device;
  Owner<RTCScene> scene;
  double scale = 1; // Embree's coordinates are ours times this power of two, in (-2, 2)

  void check(const char* step) const {
    const RTCError error = rtcGetDeviceError(device.get());
    if (error != RTC_ERROR_NONE)
      throw InputError(error == RTC_ERROR_OUT_OF_MEMORY ? InputFault::too_large
                                                        : InputFault::unsupported,
                       std::string("Embree: ") + step + " failed, error " + std::to_string(error));
  }
  void fill(RTCGeometry geometry, const TriangleMesh& mesh) const;
};

void Occluder::Embree::fill(RTCGeometry geometry, const TriangleMesh& mesh) const {
  auto* positions = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(glm::vec3), mesh.positions.size()));
  auto* triangles = static_cast<glm::uvec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              sizeof(glm::uvec3), mesh.triangles.size()));
  check("allocating the mesh");
  std::transform(mesh.positions.begin(), mesh.positions.end(), positions,
                 [&](const glm::vec3& p) { return scaled(p, scale); });
  // Rounding may give a triangle without area a normal, and so a hit anywhere; collapsed to one
  // vertex it has a zero denominator, which Embree rejects.
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles, [&](const glm::uvec3& t) {
    return blocks_nothing(mesh, t) ? glm::uvec3(t.x) : t;
  });
}

Occluder::Occluder(const TriangleMesh& mesh) : embree_(std::make_unique<Embree>()) {
  validate(mesh);
  glm::vec3 extreme(0);
  for (const glm::vec3& p : mesh.positions) extreme = glm::max(extreme, glm::abs(p));
  embree_->scale = unit_scale(extreme);

  embree_->device.reset(rtcNewDevice("verbose=0"));
  embree_->check("starting");
  embree_->scene.reset(rtcNewScene(embree_->device.get()));
  rtcSetSceneFlags(embree_->scene.get(), RTC_SCENE_FLAG_ROBUST);
  // Not high quality: its spatial splits clip triangles to rounded boxes, which may lose a hit.
  rtcSetSceneBuildQuality(embree_->scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  if (!mesh.triangles.empty()) {
    const Embree::Owner<RTCGeometry> geometry(
        rtcNewGeometry(embree_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    embree_->check("making the geometry");
    embree_->fill(geometry.get(), mesh);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(embree_->scene.get(), geometry.get());
  }
  rtcCommitScene(embree_->scene.get());
  embree_->check("building");
}

Occluder::~Occluder() = default;
Occluder::Occluder(Occluder&&) noexcept = default;
Occluder& Occluder::operator=(Occluder&&) noexcept = default;

std::optional<Hit> Occluder::intersect(const glm::vec3& origin, const glm::vec3& direction) const {
  if (direction == glm::vec3(0)) return std::nullopt;
  const double unit = unit_scale(direction);
  const glm::vec3 start = scaled(origin, embree_->scale);
  if (!is_near(start)) return std::nullopt;
  RTCRayHit query{};
  query.ray = embree_ray(start, scaled(direction, unit), infinity);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{query.hit.primID,
             {query.hit.u, query.hit.v},
             static_cast<float>(query.ray.tfar * (unit / embree_->scale))};
}

bool Occluder::occluded(const ShadowRay& ray) const {
  if (ray.direction == glm::vec3(0)) return false;
  const double unit = unit_scale(ray.direction);
  const glm::vec3 start = scaled(ray.origin, embree_->scale);
  if (!is_near(start)) return false;
  RTCRay query = embree_ray(start, scaled(ray.direction, unit),
                            static_cast<float>(ray.far * (embree_->scale / unit)));
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene.get(), &context, &query);
  return query.tfar < 0;
}

ShadowRay shadow_ray(const glm::vec3& origin, const glm::vec3& light) {
  const glm::vec3 direction = light - origin;
  if (is_finite(direction)) return {origin, direction, 1 - shadow_ray_gap};
  return {origin, 0.5F * light - 0.5F * origin, 2 * (1 - shadow_ray_gap)};
}

} // namespace lightcuts
