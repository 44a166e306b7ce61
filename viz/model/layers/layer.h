// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/methods/method.h>
#include <lightcuts/render/view/renderer.h>

namespace lightcuts::viz {

class BlockPicture;
class TruthPicture;

/// A pixel that sees a surface, with all that a layer may make its value of.
struct LayerPixel {
  const Rendering& picture;
  const Rendering* reference; ///< not null where LayerInfo::needs asks for it
  const TruthPicture* truth;  ///< not null where LayerInfo::needs asks for it
  const BlockPicture* blocks; ///< not null where LayerInfo::needs asks for it
  float black_level;          ///< of the picture's cuts, radiance
  std::size_t i;              ///< the pixel, row by row from the top left
};

[[nodiscard]] inline double sum_of_channels(const glm::vec3& v) { return double(v.x) + v.y + v.z; }

/// An error summed over RGB relative to the radiance, or to the black level where that is darker.
[[nodiscard]] inline float relative_error(const LayerPixel& p, double error,
                                          const glm::vec3& radiance) {
  const double of = std::max(sum_of_channels(radiance), 3 * double(p.black_level));
  return error == 0 ? 0 : float(error / of);
}

/// From what a layer is made beside the frame.
enum class LayerNeeds : std::uint8_t {
  frame,     ///< nothing
  reference, ///< a frame of the reference
  blocks,    ///< what the pixels of a block have shared
  truth      ///< the true contribution of every cluster at every pixel
};

/// A quantity of each pixel, all that is said of it anywhere. Each has a file in kinds/, and is
/// entered in all_layers.h.
struct LayerInfo {
  const char* name;           ///< of the command line and of files
  const char* title;          ///< for people
  const char* unit;           ///< "" where it is a mere number
  const char* meaning;        ///< what it says and its formula, one or two sentences
  bool whole_numbers = false; ///< counts
  const char* none =
      nullptr; ///< in place of mean and largest value where all are 0; default: these
  LayerNeeds needs = LayerNeeds::frame;
  /// One of the two: a heat map's value, or a colour, radiance, that is shown by exposure.
  float (*value)(const LayerPixel&) = nullptr;
  glm::vec3 (*colour)(const LayerPixel&) = nullptr;
  [[no_unique_address]] NotCopied not_copied{};
};

/// One of all_layers, by its description.
class Layer {
public:
  constexpr Layer(const LayerInfo& info) : info_(&info) {} // NOLINT: is one
  constexpr const LayerInfo* operator->() const { return info_; }
  friend constexpr bool operator==(const Layer& a, const Layer& b) { return a.info_ == b.info_; }

  [[nodiscard]] constexpr bool is_image() const { return info_->colour != nullptr; }
  [[nodiscard]] constexpr bool needs_reference() const {
    return info_->needs == LayerNeeds::reference;
  }
  [[nodiscard]] constexpr bool needs_blocks() const { return info_->needs == LayerNeeds::blocks; }
  [[nodiscard]] constexpr bool needs_truth() const { return info_->needs == LayerNeeds::truth; }

private:
  const LayerInfo* info_;
};

/// The name that the command line and files have for the layer.
[[nodiscard]] constexpr const char* name_of(Layer layer) { return layer->name; }

} // namespace lightcuts::viz
