// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/environment/environment_lights.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <queue>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/lighting/circle.h>
#include <lightcuts/render/lighting/config_check.h>
#include <lightcuts/render/lighting/environment/backdrop.h>
#include <lightcuts/render/scene/append_lights.h>

namespace lightcuts {
namespace {

/// Pixels lo.x <= x < hi.x, lo.y <= y < hi.y.
struct Rectangle {
  glm::uvec2 lo, hi;
  double weight = 0;   ///< luminance * solid angle
  double priority = 0; ///< the rectangle with the largest is cut next

  [[nodiscard]] glm::uvec2 size() const { return hi - lo; }
  /// Among equals the first in the image, so that the order is total.
  bool operator<(const Rectangle& other) const {
    if (priority != other.priority) return priority < other.priority;
    if (lo.y != other.lo.y) return lo.y > other.lo.y;
    return lo.x > other.lo.x;
  }
};

/// The map on the sphere.
class Sky {
public:
  Sky(const EnvironmentMap& map, double turn) : map_(map) {
    for (std::uint32_t y = 0; y < map.size.y; ++y)
      polar_.push_back(on_unit_circle((y + 0.5) / (2.0 * map.size.y)));
    for (std::uint32_t x = 0; x < map.size.x; ++x)
      longitude_.push_back(on_unit_circle(0.5 - (x + 0.5) / map.size.x + turn / 360));
    // cos a - cos b = 2 sin((a + b)/2) sin((b - a)/2) for the upper and lower edge of a row.
    row_scale_ = 4 * std::numbers::pi / map.size.x * on_unit_circle(0.25 / map.size.y).y;
  }

  [[nodiscard]] Rectangle whole() const { return measured({0, 0}, map_.size); }

  /// The two halves; nothing where it is one pixel.
  [[nodiscard]] std::optional<std::pair<Rectangle, Rectangle>> halves(const Rectangle& r) const {
    if (r.size() == glm::uvec2(1)) return std::nullopt;
    const glm::dvec2 extent = extent_of(r.lo, r.hi);
    const int axis = r.size().x == 1 || (r.size().y > 1 && extent.y > extent.x) ? 1 : 0;
    glm::uvec2 upper = r.hi, lower = r.lo;
    upper[axis] = lower[axis] = median(r, axis);
    return std::pair{measured(r.lo, upper), measured(lower, r.hi)};
  }

  /// Adds the light of a rectangle that is not black.
  void add_light(const Rectangle& r, LightSet& lights) const {
    glm::dvec3 irradiance(0), towards(0);
    for_each(r.lo, r.hi, [&](glm::uvec2 p) {
      irradiance += radiance(p) * solid_angle(p.y);
      towards += weight(p) * direction(p);
    });
    // All around alike: no direction is the mean.
    if (!(glm::length(towards) > 1e-6 * r.weight)) towards = direction((r.lo + r.hi - 1U) / 2U);
    lights.add_directional(glm::vec3(-glm::normalize(towards)), glm::vec3(irradiance));
  }

private:
  template <class Visit>
  static void for_each(glm::uvec2 lo, glm::uvec2 hi, const Visit& visit) {
    for (glm::uvec2 p = lo; p.y < hi.y; ++p.y)
      for (p.x = lo.x; p.x < hi.x; ++p.x) visit(p);
  }

  [[nodiscard]] glm::dvec3 radiance(glm::uvec2 p) const {
    return map_.radiance[std::size_t{p.y} * map_.size.x + p.x];
  }
  [[nodiscard]] double solid_angle(std::uint32_t row) const { return row_scale_ * polar_[row].y; }
  [[nodiscard]] double weight(glm::uvec2 p) const {
    return luminance(radiance(p)) * solid_angle(p.y);
  }
  [[nodiscard]] glm::dvec3 direction(glm::uvec2 p) const {
    const glm::dvec2 polar = polar_[p.y], longitude = longitude_[p.x];
    return {polar.y * longitude.y, polar.x, polar.y * longitude.x};
  }

  /// Width (where it is widest) and height, radians.
  [[nodiscard]] glm::dvec2 extent_of(glm::uvec2 lo, glm::uvec2 hi) const {
    double sine = 0;
    for (std::uint32_t y = lo.y; y < hi.y; ++y) sine = std::max(sine, polar_[y].y);
    return {2 * std::numbers::pi * sine * (hi.x - lo.x) / map_.size.x,
            std::numbers::pi * (hi.y - lo.y) / map_.size.y};
  }

  [[nodiscard]] Rectangle measured(glm::uvec2 lo, glm::uvec2 hi) const {
    Rectangle r{lo, hi};
    for_each(lo, hi, [&](glm::uvec2 p) { r.weight += weight(p); });
    const glm::dvec2 extent = extent_of(lo, hi);
    r.priority = r.weight * glm::dot(extent, extent);
    return r;
  }

  /// Where to cut along the axis so that the halves weigh as alike as can be.
  [[nodiscard]] std::uint32_t median(const Rectangle& r, int axis) const {
    std::vector<double> slices(r.size()[axis], 0.0);
    for_each(r.lo, r.hi, [&](glm::uvec2 p) { slices[p[axis] - r.lo[axis]] += weight(p); });
    std::uint32_t cut = 1;
    double before = slices[0];
    while (cut + 1 < slices.size() && before + 0.5 * slices[cut] < 0.5 * r.weight)
      before += slices[cut++];
    return r.lo[axis] + cut;
  }

  const EnvironmentMap& map_;
  std::vector<glm::dvec2> polar_, longitude_; // cosine and sine, per row and per column
  double row_scale_;                          // of a pixel's solid angle over the row's sine
};

std::vector<Rectangle> cut(const Sky& sky, std::uint32_t count) {
  std::vector<Rectangle> uncut;
  std::priority_queue<Rectangle> queue;
  const auto keep = [&](const Rectangle& r) {
    if (r.weight > 0) queue.push(r);
  };
  keep(sky.whole());
  while (!queue.empty() && queue.size() + uncut.size() < count) {
    const Rectangle largest = queue.top();
    queue.pop();
    if (const auto halves = sky.halves(largest)) {
      keep(halves->first);
      keep(halves->second);
    } else {
      uncut.push_back(largest);
    }
  }
  for (; !queue.empty(); queue.pop()) uncut.push_back(queue.top());
  return uncut;
}

} // namespace

void add_environment_lights(Scene& scene, const EnvironmentMap& map,
                            const EnvironmentLights& config) {
  require_within("environment lights", "count", config.count, 1, EnvironmentLights::max_count);
  validate(map);
  if (!(std::abs(config.turn) <= 360))
    throw InputError(
        InputFault::out_of_domain,
        fmt::format("environment lights: turn is {}, expected -360 to 360 degrees", config.turn));
  const Sky sky(map, config.turn);
  LightSet made; // so that a refusal adds none
  glm::dvec3 total(0);
  try {
    for (const Rectangle& r : cut(sky, config.count)) {
      sky.add_light(r, made);
      total += glm::dvec3(made[made.size() - 1].intensity);
    }
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("{}: {}", map.name, error.what()));
  }
  append(made, scene.lights);
  if (config.visible) scene.backdrops.push_back(std::make_shared<Backdrop>(map, config.turn));
  scene.notes.insert(scene.notes.end(), map.notes.begin(), map.notes.end());
  scene.notes.push_back(fmt::format("{} from {}, {:.4g} W/m^2 from all directions",
                                    counted(made.size(), "directional light"), map.name,
                                    mean(total)));
}

} // namespace lightcuts
