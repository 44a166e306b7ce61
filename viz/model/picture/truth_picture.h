// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <viz/model/picture/frame.h>

namespace lightcuts::viz {

/// The truth about each pixel of a frame, by the oracle: far slower than the frame, since every
/// light is looked at in long double.
class TruthPicture : public Picture {
public:
  explicit TruthPicture(FrameKey key);

  [[nodiscard]] const FrameKey& key() const { return key_; }
  /// Size of the clairvoyant cut; 0 where no surface is seen. Only what sources() names may be read
  /// while the picture is being made; likewise the next.
  [[nodiscard]] const std::vector<float>& clairvoyant() const { return clairvoyant_; }
  /// Cases that do not hold.
  [[nodiscard]] const std::vector<float>& violations() const { return violations_; }

protected:
  void make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) override;

private:
  struct State;
  void judge(glm::uvec2 pixel, State& state);

  FrameKey key_;
  SceneView view_;
  CutConfig cut_;
  std::vector<float> clairvoyant_, violations_;
};

} // namespace lightcuts::viz
