// SPDX-License-Identifier: MIT
#pragma once

#include <ios>
#include <sstream>
#include <string>

#include <oracle/cases/case.h>

namespace lightcuts::oracle {

/// All of a case, to the bit: cases are the same if their texts are.
inline std::string text_of(const Case& c) {
  std::ostringstream out;
  const auto say = [&out](const glm::vec3& v) {
    out << std::hexfloat << v.x << ' ' << v.y << ' ' << v.z << '\n';
  };
  for (const Light& light : c.lights) {
    out << int(light.kind) << '\n';
    say(light.position);
    say(light.intensity);
    say(light.axis);
    say({light.cos_inner, light.cos_outer, 0});
  }
  for (const CaseView& v : c.views) {
    out << gen::Scene{{}, v.view, 0} << '\n';
    for (const glm::vec3& each :
         {v.view.position, v.view.normal, v.view.to_viewer, v.view.material.diffuse})
      say(each);
    for (const std::uint32_t light : v.hidden) out << light << ' ';
  }
  for (const CaseTriangle& t : c.triangles) {
    out << t.mesh << '\n';
    for (const glm::vec3& corner : {t.a, t.b, t.c}) say(corner);
  }
  say({c.min_distance, c.cut.threshold, c.cut.black_level});
  say(c.camera.position);
  say(c.camera.target);
  out << c.cut.max_size << ' ' << c.seed << ' ' << c.image_size.x << ' ' << c.image_size.y;
  return out.str();
}

} // namespace lightcuts::oracle
