// SPDX-License-Identifier: MIT
#include <viz/model/picture/frame.h>

#include <utility>

namespace lightcuts::viz {

SceneView view_for(const FrameKey& key) {
  const OpenedScene& scene = *key.scene;
  if (key.camera == scene.scene().camera) return scene.view();
  return scene.view().seen_by(key.camera, scene.scene().image_size);
}

Frame::Frame(FrameKey key)
    // Neighbours that are lit together are lit whether all are wanted or not.
    : Picture(key.scene->scene().image_size, key.method != methods::block_cuts),
      key_(std::move(key)), view_(view_for(key_)), rendering_(blank_rendering(size())) {
  config_.method = key_.method;
  config_.cut = cut_config(key_.settings, *key_.scene, view_);
  config_.seed = key_.settings.seed;
  if (!(key_.settings.rules == ClusterRules())) config_.rules = key_.settings.rules;
  config_.done = [this](const PixelRect& rect) { done(rect); };
}

void Frame::look_at_needs() {
  const bool asked = key_.method == methods::lightcuts && !key_.scene->counterexample() &&
                     key_.settings.tree_use == TreeUse::automatic && !config_.rules;
  if (!asked || features()) return;
  // With many lights it takes seconds: not twice.
  const OpenedScene& scene = *key_.scene;
  const bool as_opened = key_.camera == scene.scene().camera &&
                         config_.cut.threshold == scene.default_threshold() &&
                         config_.cut.max_size == default_max_cut;
  const SceneFeatures found =
      as_opened ? scene.features() : find_scene_features(view_, *scene.tree(), config_.cut);
  config_.use_tree = found.tree;
  const std::lock_guard lock(needs_mutex_);
  features_ = found;
}

std::optional<SceneFeatures> Frame::features() const {
  const std::lock_guard lock(needs_mutex_);
  return features_;
}

bool Frame::sums_all_lights() const {
  const auto found = features();
  return key_.method == methods::reference || (found && !found->tree);
}

void Frame::make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) {
  look_at_needs();
  config_.progress = progress;
  render_into(rendering_, view_, *key_.scene->tree(), config_, wanted);
}

} // namespace lightcuts::viz
