// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts::oracle {

/// The scene lit by one group of its lights alone, by cuts through a tree of their own. The sum
/// over all groups is the picture, but for errors.
struct GroupPicture {
  std::string name; ///< "others": the lights that have no group
  std::size_t lights = 0;
  Rendering rendering; ///< emission is that of the scene; it belongs to no group

  /// Sums over all pixels and channels.
  [[nodiscard]] double light() const;
  [[nodiscard]] double certified_error() const;
};

/// The lights of each group, those that have none last; a name that several LightGroups have is one
/// group. Nothing where no light has a group.
[[nodiscard]] std::vector<std::pair<std::string, LightSet>> lights_by_group(const Scene& scene);

/// One picture for each of lights_by_group(), rendered as `config` says but for use_tree, which is
/// decided anew for each, at the black level of the whole. Throws Cancelled.
[[nodiscard]] std::vector<GroupPicture>
render_groups(const SceneView& view, const RenderConfig& config, const BuildConfig& builder);

} // namespace lightcuts::oracle
