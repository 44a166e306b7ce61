// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include <lightcuts/box.h>
#include <lightcuts/light_set.h>

namespace lightcuts {

/// The definition of the greedy tree, followed to the letter in O(N^3).
struct NaiveCluster {
  Box box, axes;
  glm::dvec3 intensity;
  double weight;       ///< of all channels
  std::uint32_t first; ///< lowest light index
  std::shared_ptr<const NaiveCluster> children[2];
};

/// Merges the cheapest of all pairs each time, that with the lowest light indices among equals.
/// Lights of one kind.
inline std::shared_ptr<const NaiveCluster> naive_build(const LightSet& lights) {
  std::vector<std::shared_ptr<const NaiveCluster>> open; // in the order of their lowest lights
  Box all = Box::empty();
  for (const Light& light : lights) all.extend(light.position);
  const double diagonal = std::sqrt(squared_diagonal_of_union(all, all));
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const glm::dvec3 power(lights[i].intensity);
    const Box box{lights[i].position, lights[i].position};
    const glm::vec3 axis = float(std::sqrt(diagonal) / 4) * lights[i].axis;
    open.push_back(std::make_shared<NaiveCluster>(
        NaiveCluster{box, {axis, axis}, power, power.x + power.y + power.z, i, {}}));
  }
  while (open.size() > 1) {
    std::size_t a = 0, b = 1;
    const auto cost = [&open](std::size_t i, std::size_t j) {
      const double weight = open[i]->weight + open[j]->weight;
      const double spread = squared_diagonal_of_union(open[i]->axes, open[j]->axes);
      return weight * (squared_diagonal_of_union(open[i]->box, open[j]->box) + spread * spread);
    };
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::size_t j = i + 1; j < open.size(); ++j)
        if (cost(i, j) < cost(a, b)) a = i, b = j;
    NaiveCluster merged{open[a]->box,
                        open[a]->axes,
                        open[a]->intensity + open[b]->intensity,
                        open[a]->weight + open[b]->weight,
                        open[a]->first,
                        {open[a], open[b]}};
    merged.box.extend(open[b]->box);
    merged.axes.extend(open[b]->axes);
    open[a] = std::make_shared<NaiveCluster>(merged);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(b));
  }
  return open.empty() ? nullptr : open.front();
}

} // namespace lightcuts
