// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lightcuts {

inline void expect_near(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LE(glm::distance(a, b), 1e-5F)
      << a.x << ' ' << a.y << ' ' << a.z << " expected " << b.x << ' ' << b.y << ' ' << b.z;
}

} // namespace lightcuts
