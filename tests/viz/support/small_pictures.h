// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <lightcuts/core/jobs/seconds_since.h>
#include <viz/model/picture/frame.h>
#include <viz/model/scene/opened_scene.h>

namespace lightcuts::viz {

/// A room with three blocks and 200 lights.
inline const char* const small_spec = "cloud?lights=200&blocks=3";

inline SceneRequest small_request() {
  return {.spec = small_spec, .image_size = glm::uvec2(32, 24)};
}

inline std::shared_ptr<const OpenedScene> opened(const std::string& spec, glm::uvec2 size) {
  SceneRequest request;
  request.spec = spec;
  request.image_size = size;
  return std::make_shared<const OpenedScene>(request);
}

/// A scene of 32 x 24 pixels that all tests share: it does not change.
inline const std::shared_ptr<const OpenedScene>& small_scene() {
  static const auto scene = opened(small_spec, {32, 24});
  return scene;
}

/// A pixel of small_scene(): what it shows, and which lights are seen there.
struct SmallPoint {
  VisiblePoint p;
  explicit SmallPoint(glm::uvec2 pixel) : p(*small_scene()->view().at(pixel)) {}
  bool operator()(std::uint32_t light) const { return small_scene()->view().casts_to(p, light); }
};

/// Some that see surfaces.
inline constexpr glm::uvec2 some_pixels[] = {{16, 12}, {3, 20}, {30, 5}, {9, 22}};

/// Cuts wherever there could be any.
inline ShadingSettings always_cuts() {
  ShadingSettings settings;
  settings.threshold = 0.1F;
  settings.tree_use = TreeUse::always;
  return settings;
}

inline FrameKey small_key(Method method = methods::lightcuts,
                          const ShadingSettings& settings = always_cuts()) {
  return {small_scene(), method, settings, small_scene()->scene().camera};
}

/// A whole picture.
template <class P>
std::shared_ptr<P> made(const FrameKey& key) {
  auto picture = std::make_shared<P>(key);
  picture->advance();
  return picture;
}

/// Only its coarsest pixels.
template <class P>
std::shared_ptr<P> begun(const FrameKey& key) {
  auto picture = std::make_shared<P>(key);
  const glm::uvec2 coarse = (picture->size() + (Picture::steps[0] - 1)) / Picture::steps[0];
  const double share = double(coarse.x) * coarse.y / double(picture->pixel_count());
  picture->advance(Progress::until([&] { return picture->share() >= share; }));
  return picture;
}

/// Waits, but not for ever; whether it came true.
inline bool comes_true(const std::function<bool()>& condition) {
  for (const auto start = Clock::now(); seconds_since(start) < 20;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

} // namespace lightcuts::viz
