// SPDX-License-Identifier: MIT
#include <viz/panels/cut/scene_panel.h>

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <lightcuts/render/scene/bounds.h>

#include <viz/gl/scene/picking.h>
#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

constexpr double radians_per_pixel = 0.008;
/// How near to a point on the screen a click has to be, pixels.
constexpr double click_reach = 12;

bool dragged(ImGuiMouseButton button) {
  return ImGui::IsItemActive() && ImGui::IsMouseDragging(button, 2);
}

} // namespace

void ScenePanel::draw(Workbench& workbench) {
  draw_options();
  draw_legend(workbench);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 available = ImGui::GetContentRegionAvail();
  const glm::uvec2 size(std::max(available.x, 16.0F), std::max(available.y, 16.0F));
  ImGui::InvisibleButton("scene", {float(size.x), float(size.y)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  if (scene_ == workbench.scene()) handle_mouse(workbench, to_dvec(origin), size);
  update_picture(workbench, size);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (!failure_.empty()) {
    list->AddText(origin, violation_colour, ("This cannot be drawn: " + failure_).c_str());
    return;
  }
  // Textures begin at their lowest row.
  list->AddImage(texture_id(picture_->texture()), origin,
                 {origin.x + float(size.x), origin.y + float(size.y)}, {0, 1}, {1, 0});
}

void ScenePanel::update_picture(Workbench& workbench, glm::uvec2 size) {
  try {
    adopt(workbench, size);
    if (picture_) render(workbench, size);
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
}

void ScenePanel::adopt(const Workbench& workbench, glm::uvec2 size) {
  if (scene_ == workbench.scene()) return;
  const bool same = scene_ && scene_->request().spec == workbench.scene()->request().spec;
  scene_ = workbench.scene();
  failure_.clear();
  drawn_.reset();
  picture_.reset();
  picture_ = std::make_unique<ScenePicture>(scene_->scene());
  const Box box = picture_->bounds();
  options_.scene_diagonal = float(diagonal_length(box));
  if (same) return;
  camera_ = OrbitCamera::from_camera(scene_->scene().camera, scene_->scene().camera.target);
  camera_.orbit(0.5, 0.35); // beside the camera, not in its place
  camera_.fit(box, size);
}

void ScenePanel::draw_options() {
  int by = int(options_.colour_by);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
  if (ImGui::Combo("clusters by", &by, "true error\0bound\0lights\0"))
    options_.colour_by = ClusterColour(by);
  tooltip("The colour of a cluster's box. The selected cluster is green.");
  ImGui::SameLine();
  ImGui::Checkbox("boxes", &options_.boxes);
  ImGui::SameLine();
  ImGui::Checkbox("lines", &options_.lines);
  tooltip(
      "From the shading point to representatives: white where they are seen, red where blocked; "
      "of pixels lit together blue where proven to be seen, violet where proven to be hidden, "
      "and orange where a share is estimated. "
      "Left drag turns the scene, right drag moves it, the wheel goes nearer; a click selects "
      "the cluster whose representative is nearest.");
}

void ScenePanel::draw_legend(const Workbench& workbench) const {
  const auto& result = workbench.inspection();
  if (!result || result->inspection.clusters.empty()) {
    ImGui::TextColored(quiet_text, "Click a pixel: its shading point and cut are drawn here.");
    return;
  }
  const HeatMapScale scale = cluster_scale(result->inspection.clusters, options_.colour_by);
  const float step = ImGui::GetFontSize() * 0.5F;
  ImGui::TextColored(quiet_text, "%s", short_text(scale.lo).c_str());
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i) {
    const Rgba8 c = cluster_colour(value_at((float(i) + 0.5F) / steps, scale), scale);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x + float(i) * step, at.y + 2},
        {at.x + float(i + 1) * step, at.y + ImGui::GetTextLineHeight() - 2},
        IM_COL32(c.r, c.g, c.b, 255));
  }
  ImGui::Dummy({steps * step, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
  ImGui::TextColored(quiet_text, "%s%s", short_text(scale.hi).c_str(),
                     options_.colour_by == ClusterColour::lights ? " lights" : " radiance");
}

Overlay ScenePanel::overlay_for(Workbench& workbench) const {
  const auto& result = workbench.inspection();
  if (!result || !result->inspection.sees_surface) return {};
  OverlayOptions options = options_;
  options.selected = workbench.state.node;
  std::vector<ClusterRow> rows = result->inspection.clusters;
  // One beside the cut is drawn with it.
  const bool in_cut = std::any_of(rows.begin(), rows.end(), [&](const ClusterRow& row) {
    return row.node == workbench.state.node;
  });
  if (const auto row = workbench.selected_row(); row && !in_cut) rows.push_back(*row);
  return overlay_of(result->inspection.position, result->inspection.normal, rows, options);
}

void ScenePanel::render(Workbench& workbench, glm::uvec2 size) {
  Drawn now{size,
            camera_.to_camera(),
            workbench.camera(),
            workbench.inspection(),
            workbench.state.node,
            int(options_.colour_by),
            options_.boxes,
            options_.lines};
  if (drawn_ == now) return;
  picture_->draw(
      camera_, size,
      {.traced_camera = workbench.camera(), .traced_size = workbench.scene()->scene().image_size},
      overlay_for(workbench));
  drawn_ = std::move(now);
}

void ScenePanel::handle_mouse(Workbench& workbench, const glm::dvec2& origin, glm::uvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) camera_.dolly(std::pow(0.88, io.MouseWheel));
  if (dragged(ImGuiMouseButton_Left))
    camera_.orbit(-radians_per_pixel * io.MouseDelta.x, radians_per_pixel * io.MouseDelta.y);
  if (dragged(ImGuiMouseButton_Right) || dragged(ImGuiMouseButton_Middle))
    camera_.pan(to_dvec(io.MouseDelta), size);
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
  if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
      std::hypot(moved.x, moved.y) < 3)
    pick(workbench, to_dvec(io.MousePos) - origin, size);
}

void ScenePanel::pick(Workbench& workbench, const glm::dvec2& at, glm::uvec2 size) const {
  const auto& result = workbench.inspection();
  if (!result) return;
  const std::vector<ClusterRow>& rows = result->inspection.clusters;
  std::vector<glm::dvec3> places;
  places.reserve(rows.size());
  for (const ClusterRow& row : rows) places.emplace_back(row.representative_position);
  if (const auto picked = pick_point(camera_.frame(size), size, places, at, click_reach))
    workbench.state.node = rows[*picked].node;
}

} // namespace lightcuts::viz
