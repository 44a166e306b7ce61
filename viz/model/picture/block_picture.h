// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <viz/model/picture/frame.h>

namespace lightcuts::viz {

/// What the pixels of a frame have shared and what was proven for them. The frame does not keep
/// that, so squares are lit once more, which takes as long as the frame; of methods that light each
/// pixel alone it is known at once.
class BlockPicture : public Picture {
public:
  explicit BlockPicture(FrameKey key);

  [[nodiscard]] const FrameKey& key() const { return key_; }
  /// Pixels in the pixel's block, 1 where it stands alone; 0 where no surface is seen. Only what
  /// sources() names may be read while the picture is being made; likewise the next.
  [[nodiscard]] const std::vector<float>& block_size() const { return block_size_; }
  /// LitSquare::proven(); 0 where each pixel is lit alone, by rays.
  [[nodiscard]] const std::vector<float>& proven() const { return proven_; }

protected:
  void make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) override;

private:
  void light_square(glm::uvec2 corner);

  FrameKey key_;
  SceneView view_;
  CutConfig cut_;
  std::vector<float> block_size_, proven_;
};

} // namespace lightcuts::viz
