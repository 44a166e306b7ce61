// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/render/io/scene_request.h>
#include <lightcuts/render/view/scene_features.h>
#include <lightcuts/render/view/scene_view.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/subjects/subject.h>
#include <oracle/subjects/topology.h>

namespace lightcuts::viz {

/// Lights that a scene without any gets, so that there is something to see.
inline constexpr std::uint32_t lights_for_dark_scenes = 1000;

/// A counterexample of the oracle, and where in it the property fails.
struct OpenedCounterexample {
  oracle::SavedCounterexample saved;
  std::size_t view = 0;              ///< index of the shading point
  std::optional<std::uint32_t> node; ///< the first cluster that breaks it; of cuts: none
  CutConfig cut; ///< of the cut that breaks it; of a property of bounds, the case's own
  bool still_fails = false;
  std::string message;     ///< what the oracle says of it now
  std::string explanation; ///< see explain()
  // Of that cluster, radiance: what the subject says, and what is true with all lights seen and
  // with those that are.
  glm::vec3 bound{0};
  glm::dvec3 estimate{0}, open_truth{0}, seen_truth{0};
};

/// A scene and all that is derived from it once. Does not change; may be used by many threads.
class OpenedScene {
public:
  /// Opens, builds and looks: seconds where lights are many. Throws InputError, with a message for
  /// the user; and Cancelled soon after it is, but for the reading of a file.
  explicit OpenedScene(SceneRequest request, const Progress& progress = {});
  OpenedScene(const OpenedScene&) = delete;
  OpenedScene& operator=(const OpenedScene&) = delete;

  [[nodiscard]] const SceneRequest& request() const { return request_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// The scene by its own camera.
  [[nodiscard]] const SceneView& view() const { return *view_; }
  /// The library's tree; of a foreign subject's counterexample the library's as well.
  [[nodiscard]] const std::shared_ptr<const LightTree>& tree() const { return tree_; }
  [[nodiscard]] const oracle::Topology& topology() const { return topology_; }
  /// How many nodes are above the node; the root has 0.
  [[nodiscard]] std::uint32_t depth(std::uint32_t node) const { return depth_[node]; }
  [[nodiscard]] float default_threshold() const { return default_threshold_; }
  /// Found for the scene's own camera at default_threshold() and default_max_cut; not of a
  /// counterexample.
  [[nodiscard]] const SceneFeatures& features() const { return features_; }
  /// Radiance under which errors are not chased; see find_scene_features().
  [[nodiscard]] float black_level() const { return black_level_; }
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

  /// The counterexample that was opened; nothing where it was a scene.
  [[nodiscard]] const std::optional<OpenedCounterexample>& counterexample() const {
    return counterexample_;
  }
  /// The questions that the counterexample's subject answers; of a scene, all that the library
  /// does.
  [[nodiscard]] oracle::Parts parts() const;
  /// A new user of the tree of the counterexample's subject; only with a counterexample.
  [[nodiscard]] std::unique_ptr<oracle::SubjectTree> subject_tree() const {
    return subject_tree_->for_another_thread();
  }

private:
  void open_counterexample();
  void judge_counterexample();
  void build_tree(const Progress& progress);

  SceneRequest request_;
  Scene scene_;
  std::unique_ptr<SceneView> view_;
  std::shared_ptr<const LightTree> tree_;
  oracle::Topology topology_;
  std::vector<std::uint32_t> depth_;
  float default_threshold_ = 0, black_level_ = 0;
  SceneFeatures features_;
  double build_seconds_ = 0;
  std::optional<OpenedCounterexample> counterexample_;
  std::shared_ptr<const oracle::Subject> subject_;
  std::unique_ptr<oracle::SubjectTree> subject_tree_;
};

} // namespace lightcuts::viz
