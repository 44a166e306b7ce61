// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <lightcuts/render/io/models/gltf/gltf_file.h>

namespace lightcuts {

/// The elements of an accessor as numbers. Integers that are `normalized` are the fractions that
/// they stand for (glTF 2.0, 3.11), others themselves: KHR_mesh_quantization allows both.
struct GltfElements {
  std::size_t count = 0;
  std::size_t width = 1; ///< numbers per element: 1 of a SCALAR, 16 of a MAT4
  std::vector<float> values;

  [[nodiscard]] glm::vec2 vec2(std::size_t i) const {
    return {values[width * i], values[width * i + 1]};
  }
  [[nodiscard]] glm::vec3 vec3(std::size_t i) const {
    return {values[width * i], values[width * i + 1], values[width * i + 2]};
  }
  [[nodiscard]] glm::vec4 vec4(std::size_t i) const { return {vec3(i), values[width * i + 3]}; }
};

/// Reads an accessor, also a sparse one, whose elements have from `least` to `most` numbers. Throws
/// GltfFault where it has others, or leaves its bufferView.
[[nodiscard]] GltfElements read_elements(const GltfFile& file, std::size_t accessor,
                                         std::size_t least, std::size_t most);

/// Reads an accessor of unsigned integers.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfFile& file, std::size_t accessor);

} // namespace lightcuts
