// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/cases/case.h>

namespace lightcuts::oracle {

/// Something of everything that a case may have.
inline Case all_features_case() {
  Case on;
  on.lights = {{.kind = LightKind::omni, .position = {0.1F, 0, 1}, .intensity = {1, 2, 3}},
               {.kind = LightKind::oriented,
                .position = {0, 1, 2},
                .intensity = glm::vec3(2),
                .axis = {0, 0, -1}},
               {.kind = LightKind::spot,
                .position = {1, 1, 2},
                .intensity = glm::vec3(4),
                .axis = {0, 0, -1},
                .cos_inner = 0.875F,
                .cos_outer = 0.25F},
               {.kind = LightKind::directional, .position = {0, 0, 1}, .intensity = {1, 1, 0}},
               {.kind = LightKind::profile,
                .position = {0, 2, 1},
                .intensity = {1, 0.5F, 2},
                .axis = {0, 0, -1},
                .plane = {0, 1, 0},
                .profile = Profile({.cosines = {1, 0.5F, -1},
                                    .plane_cosines = {1, -0.5F, -0.5F},
                                    .plane_sines = {0, 0.8660254F, -0.8660254F},
                                    .shares = {1, 0.5F, 0, 1, 0.75F, 0.25F, 1, 0.125F, 0}})}};
  on.min_distance = 0.0625F;
  const glm::vec3 up(0, 0, 1);
  on.views = {
      {{{0, 0, 0}, up, up, {glm::vec3(0.5F), Phong{glm::vec3(0.25F), 8}}}, {1, 2}},
      {{{0, 1, 0}, up, {0, 0.6F, 0.8F}, {glm::vec3(0.5F), Ward{glm::vec3(0.5F), 0.25F}}}, {}},
      {{{1, 0, 0}, up, up, {glm::vec3(0.1F), CookTorrance{glm::vec3(0.04F), 0.5F}}}, {0}},
      {{{1, 1, 0}, up, up, {glm::vec3(1), {}}}, {}}};
  on.cut = {0.1F, 7, 0.001F};
  on.seed = 12345678901234567890U;
  on.triangles = {{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}, 0},
                  {{0, 0, 0.5F}, {1, 0, 0.5F}, {0, 1, 0.5F}, 3}};
  on.camera = {{0, -3, 3}, {0, 0, 0}, {0, 0, 1}, 50};
  on.image_size = {3, 2};
  return on;
}

} // namespace lightcuts::oracle
