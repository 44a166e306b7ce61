// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/render/scene/scene.h>
#include <oracle/cases/stress_scene.h>

namespace lightcuts::oracle {

/// A shading point, and which lights are not seen from it.
struct CaseView {
  gen::View view = {};
  std::vector<std::uint32_t> hidden = {}; ///< indices of lights, ascending

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("view", &CaseView::view, domain::inlined);
    field("hidden", &CaseView::hidden);
  }

  bool operator==(const CaseView&) const = default;
};

/// A triangle of a case; its surface is the first view's material.
struct CaseTriangle {
  glm::vec3 a{0}, b{0}, c{0}; ///< corners, metres
  std::uint32_t mesh = 0;     ///< below max_meshes; triangles of one mesh are neighbours
  static constexpr std::uint32_t max_meshes = 1U << 16;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("a", &CaseTriangle::a);
    field("b", &CaseTriangle::b);
    field("c", &CaseTriangle::c);
    field("mesh", &CaseTriangle::mesh, domain::within(0, max_meshes - 1));
  }

  bool operator==(const CaseTriangle&) const = default;
};

/// All that a subject is judged on at once, as small as a counterexample wants to be: lights and
/// shading points, or, where there are triangles, lights and a picture.
struct Case {
  std::vector<Light> lights;
  float min_distance = 0; ///< 0: no clamp
  std::vector<CaseView> views;
  CutConfig cut;
  std::uint64_t seed = 1; ///< of the tree
  bool draws = false;     ///< whether to judge by many random draws, too
  /// What a tree has behind it when its answers are compared with a new one's: trees of as many
  /// other lights that were built before, and questions about other views. Both 0: not compared.
  std::uint32_t builds = 0, questions = 0;
  std::vector<CaseTriangle> triangles;
  Camera camera;            ///< of the picture
  glm::uvec2 image_size{8}; ///< pixels
  /// A case is judged by brute force, pixel by pixel.
  static constexpr unsigned max_image_side = 64;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("lights", &Case::lights);
    field("min_distance", &Case::min_distance, domain::not_negative);
    field("views", &Case::views);
    field("cut", &Case::cut);
    field("seed", &Case::seed);
    field("draws", &Case::draws, domain::optional);
    field("builds", &Case::builds, Domain{.least = 0, .most = 1 << 20, .optional = true});
    field("questions", &Case::questions, Domain{.least = 0, .most = 1 << 20, .optional = true});
    field("triangles", &Case::triangles, domain::optional);
    field("camera", &Case::camera, domain::optional);
    field("image_size", &Case::image_size,
          Domain{.least = 1, .most = max_image_side, .optional = true});
  }

  [[nodiscard]] LightSet light_set() const;
  /// The triangles with the lights and the first view's material.
  [[nodiscard]] lightcuts::Scene scene() const;
  bool operator==(const Case&) const = default;
};

/// More lights than that: a case is judged by what costs little for each of them. Every tree and
/// bound, two cuts, and some draws; not what is built anew or asked of each light of each cluster.
inline constexpr std::size_t many_lights = 1024;

/// Among how many cases with draws, in one run, the rate of false alarms is shared: no run has
/// more.
inline constexpr std::uint64_t most_cases_with_draws = 10'000;

} // namespace lightcuts::oracle
