// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <oracle/cases/stress_scene.h>

namespace lightcuts::gen {

/// Values that are simpler than the given one, the simplest first; none for the simplest of all:
/// fewer lights, round numbers, the origin, +z.
std::vector<float> simpler(const float& value);
std::vector<glm::vec3> simpler(const glm::vec3& value);
std::vector<glm::vec3> simpler_directions(const glm::vec3& v);
std::vector<View> simpler(const View& view);
std::vector<Light> simpler(const Light& light);
std::vector<Scene> simpler(const Scene& scene);

} // namespace lightcuts::gen
