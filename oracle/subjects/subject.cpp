// SPDX-License-Identifier: MIT
#include <oracle/subjects/subject.h>

#include <algorithm>

#include <lightcuts/render/view/renderer.h>

namespace lightcuts::oracle {
namespace {

[[noreturn]] void not_a_part(Part part) {
  throw std::logic_error(std::string("asked a subject for what it has not: ") + name_of(part));
}

} // namespace

const char* name_of(Part part) {
  switch (part) {
  case Part::bounds:
    return "bounds";
  case Part::lower_bounds:
    return "lower bounds";
  case Part::estimates:
    return "estimates";
  case Part::cuts:
    return "cuts";
  case Part::sampling:
    return "sampling";
  case Part::refinement_order:
    return "refinement order";
  case Part::occlusion:
    return "occlusion";
  case Part::pictures:
    return "pictures";
  case Part::random_cuts:
    return "random cuts";
  case Part::block_bounds:
    return "block bounds";
  case Part::profiles:
    return "lights with profiles";
  case Part::proofs:
    return "proven visibility";
  case Part::greedy_tree:
    return "greedy tree";
  case Part::library_rules:
    break;
  }
  return "rules of the library";
}

std::vector<std::string> names_without(Parts parts) {
  std::vector<std::string> names;
  for (int i = 0; i < part_count; ++i)
    if (const auto part = Part(1U << unsigned(i)); !has(parts, part))
      names.emplace_back(name_of(part));
  return names;
}

bool takes(Parts parts, std::span<const Light> lights) {
  return has(parts, Part::profiles) ||
         std::none_of(lights.begin(), lights.end(),
                      [](const Light& light) { return light.kind == LightKind::profile; });
}

glm::vec3 SubjectTree::bound(std::uint32_t, const ShadingPoint&) { not_a_part(Part::bounds); }

void SubjectTree::bounds(const ShadingPoint& point, std::span<glm::vec3> out) {
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = bound(i, point);
}

void SubjectTree::block_bounds(std::span<const ShadingPoint>, std::span<glm::vec3>) {
  not_a_part(Part::block_bounds);
}

glm::vec3 SubjectTree::lower_bound(std::uint32_t, const ShadingPoint&) {
  not_a_part(Part::lower_bounds);
}

glm::dvec3 SubjectTree::estimate(std::uint32_t, const ShadingPoint&, const glm::vec3&) {
  not_a_part(Part::estimates);
}

Cut SubjectTree::select(const ShadingPoint&, const CutConfig&,
                        const std::function<bool(std::uint32_t)>&) {
  not_a_part(Part::cuts);
}

DrawnLight SubjectTree::sample(std::uint32_t, const ShadingPoint&, double) {
  not_a_part(Part::sampling);
}

void SubjectTree::samples(std::uint32_t node, const ShadingPoint& point, std::span<const double> u,
                          std::span<DrawnLight> out) {
  for (std::size_t i = 0; i < u.size(); ++i) out[i] = sample(node, point, u[i]);
}

double SubjectTree::probability(std::uint32_t, const ShadingPoint&, std::uint32_t) {
  not_a_part(Part::sampling);
}

std::vector<double> SubjectTree::probabilities(std::uint32_t node, const ShadingPoint& point,
                                               std::span<const std::uint32_t> lights) {
  std::vector<double> result;
  for (const std::uint32_t light : lights) result.push_back(probability(node, point, light));
  return result;
}

Cut SubjectTree::draw(const ShadingPoint&, const CutConfig&, std::uint64_t,
                      const std::function<bool(std::uint32_t)>&) {
  not_a_part(Part::random_cuts);
}

void SubjectTree::draws(const ShadingPoint& point, const CutConfig& config,
                        std::span<const std::uint64_t> queries,
                        const std::function<bool(std::uint32_t)>& visible,
                        const std::function<void(const Cut&)>& take) {
  for (const std::uint64_t query : queries) take(draw(point, config, query, visible));
}

std::unique_ptr<SubjectTree> Subject::build_after(std::unique_ptr<SubjectTree> before,
                                                  const LightSet& lights,
                                                  std::uint64_t seed) const {
  before.reset();
  return build(lights, seed);
}

bool Subject::refined_before(double, double) const { not_a_part(Part::refinement_order); }

bool Subject::sees(const SceneView&, const VisiblePoint&, std::uint32_t) const {
  not_a_part(Part::occlusion);
}

std::vector<ProvenSight> Subject::prove(const SceneView&, const LightTree&,
                                        std::span<const VisiblePoint>) const {
  not_a_part(Part::proofs);
}

Rendering Subject::render(const SceneView&, const LightTree&, const RenderConfig&) const {
  not_a_part(Part::pictures);
}

} // namespace lightcuts::oracle
