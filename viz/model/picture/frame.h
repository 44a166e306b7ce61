// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <viz/model/picture/picture.h>
#include <viz/model/picture/shading_settings.h>

namespace lightcuts::viz {

/// All that a picture depends on.
struct FrameKey {
  std::shared_ptr<const OpenedScene> scene;
  Method method = methods::lightcuts;
  ShadingSettings settings;
  Camera camera;

  bool operator==(const FrameKey&) const = default;
};

/// The scene as the key's camera sees it. Quick where that is the scene's own.
[[nodiscard]] SceneView view_for(const FrameKey& key);

/// A picture by one of the library's methods. Of a counterexample, the library's as well: only its
/// shading point is the subject's.
class Frame : public Picture {
public:
  explicit Frame(FrameKey key);

  [[nodiscard]] const FrameKey& key() const { return key_; }
  [[nodiscard]] const SceneView& view() const { return view_; }
  /// Only what sources() names may be read while the picture is being made.
  [[nodiscard]] const Rendering& rendering() const { return rendering_; }
  [[nodiscard]] const CutConfig& cut() const { return config_.cut; }
  /// Whether the tree is of use, among others; nothing before the picture has begun, and where it
  /// is not asked for.
  [[nodiscard]] std::optional<SceneFeatures> features() const;
  /// Whether all lights were summed: the reference, and lightcuts where the tree does not pay.
  [[nodiscard]] bool sums_all_lights() const;

protected:
  void make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) override;

private:
  void look_at_needs();

  FrameKey key_;
  SceneView view_;
  RenderConfig config_;
  Rendering rendering_;
  mutable std::mutex needs_mutex_;
  std::optional<SceneFeatures> features_;
};

} // namespace lightcuts::viz
