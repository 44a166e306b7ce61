// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lightcuts {

/// Cuts a polygon into triangles, n - 2 of them, as indices of its corners, in its sense of
/// rotation: a convex one as a fan about its first corner, any other by cutting off ears (Meisters
/// 1975) seen along its mean normal. One that crosses itself comes out as some triangles of its
/// corners. 3 corners at least, finite.
[[nodiscard]] std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> corners);

} // namespace lightcuts
