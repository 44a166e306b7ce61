// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>

#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// The unit direction nearest to `plane` that is perpendicular to the axis, both unit; none where
/// they are parallel within a thousandth.
[[nodiscard]] std::optional<glm::vec3> plane_beside(const glm::vec3& axis, const glm::vec3& plane);

/// Light::plane where nothing says it: +x, or, of an axis along x, +z; perpendicular to the axis.
[[nodiscard]] glm::vec3 usual_plane(const glm::vec3& axis);

/// colour times peak, as floats; +inf, which no light may have, where it exceeds them.
[[nodiscard]] glm::vec3 scaled_intensity(const glm::vec3& colour, double peak);

/// Integral of the share over all directions, sr: W per W/sr of the light's intensity.
[[nodiscard]] double solid_share(const ProfileTable& table);

/// A direction drawn in proportion to the share along it, by rejection; u is of the unit square. Of
/// a black profile: the axis.
[[nodiscard]] glm::dvec3 profile_direction(const Light& light, const glm::dvec2& u, Random& random);

/// A luminaire beside a road, made up: two lobes to the sides, more light ahead than behind.
[[nodiscard]] const Profile& street_luminaire();

} // namespace lightcuts
