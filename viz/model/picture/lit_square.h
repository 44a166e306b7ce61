// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/blocks/block_cut_selector.h>
#include <lightcuts/render/view/pixel_square.h>

#include <viz/model/picture/sight.h>

namespace lightcuts::viz {

/// A square of pixels lit as the renderer does it by block-cuts, to the same bits, with what the
/// renderer has no use for: which pixels shared a cut, and how they know what they see.
class LitSquare {
public:
  /// The square that has the pixel. seed: RenderConfig::seed.
  LitSquare(const SceneView& view, const LightTree& tree, const CutConfig& config,
            std::uint64_t seed, glm::uvec2 pixel);

  /// Those that see a surface, row by row.
  [[nodiscard]] const std::vector<glm::uvec2>& pixels() const { return square_.pixels; }
  /// The index of a pixel among them, which it has to be.
  [[nodiscard]] std::size_t index_of(glm::uvec2 pixel) const;

  // Of the pixel with an index:
  [[nodiscard]] const BlockCut& cut(std::size_t p) const { return cuts_[p]; }
  [[nodiscard]] const std::vector<CutCluster>& clusters(std::size_t p) const {
    return clusters_[p];
  }
  /// Of each of its clusters; nothing where no light of the cluster can reach the pixel, so that
  /// none was looked at.
  [[nodiscard]] std::vector<std::optional<Sight>> sights(std::size_t p) const;
  /// The indices of the pixels that went down the tree together with it, itself among them.
  [[nodiscard]] const std::vector<std::uint32_t>& block(std::size_t p) const {
    return blocks_[block_of_[p]];
  }
  /// Of the light, the share for which it is proven that it is seen or that it is not, 0 to 1: by
  /// the estimates, those of hidden clusters as they would be if these were seen.
  [[nodiscard]] double proven(std::size_t p) const;

private:
  class Recorder;

  const LightTree* tree_;
  PixelSquare square_;
  std::vector<BlockCut> cuts_;
  std::vector<std::vector<CutCluster>> clusters_;
  std::vector<std::vector<std::uint32_t>> blocks_; ///< those that were parted, too
  std::vector<std::size_t> block_of_;
  std::vector<std::vector<ProvenSight>> proofs_;  ///< by pixel, then cluster
  std::vector<std::vector<std::uint32_t>> asked_; ///< lights, by pixel
};

} // namespace lightcuts::viz
