// SPDX-License-Identifier: MIT
#include <viz/panels/picture/image_panel.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <imgui.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/film.h>
#include <lightcuts/render/view/camera.h>
#include <viz/model/layers/value_text.h>
#include <viz/model/picture/outline.h>
#include <viz/panels/gui/drawing.h>
#include <viz/panels/picture/pixel_text.h>

namespace lightcuts::viz {
namespace {

/// Screen pixels per image pixel from which values stand in the pixels.
constexpr double zoom_for_values = 44;
/// Time that a rasterised picture may take of a frame of the window, milliseconds.
constexpr double raster_budget = 6, raster_budget_moving = 12;

constexpr ImU32 block_colour = IM_COL32(90, 200, 255, 255); // not that of the selection

constexpr double camera_radians_per_pixel = 0.006;

bool is_dragged(ImGuiMouseButton button) {
  return ImGui::IsItemActive() && ImGui::IsMouseDragging(button, 3);
}

} // namespace

void ImagePanel::draw(Workbench& workbench) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  area_ = {to_dvec(origin), glm::max(to_dvec(size), glm::dvec2(1))};
  refresh(workbench);
  ImGui::InvisibleButton("image", {float(area_.size.x), float(area_.size.y)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  handle_mouse(workbench);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(origin, to_imgui(area_.origin + area_.size), true);
  draw_pictures(workbench);
  draw_pixel_values(workbench);
  draw_block(workbench);
  draw_selection(workbench);
  draw_split(workbench);
  list->PopClipRect();
  draw_tooltip(workbench);
}

// ---- what is shown

void ImagePanel::refresh(Workbench& workbench) {
  raster_shown_ = false;
  remember_exposure(workbench);
  const bool raster_only = moving_.has_value();
  const DisplayMethod left = flipped_      ? DisplayMethod(methods::reference)
                             : raster_only ? DisplayMethod::raster()
                                           : workbench.state.display;
  refresh_one(workbench, left, {}, shown_);
  // By the same scale: else the two could not be compared.
  if (workbench.state.split)
    refresh_one(workbench, workbench.state.compared, shown_.coloured().scale, compared_);
  view_ = settled(workbench.state.image, area_, shown_.coloured().size);
}

void ImagePanel::refresh_one(Workbench& workbench, const DisplayMethod& display,
                             const std::optional<HeatMapScale>& scale, ShownPicture& into) {
  try {
    if (display.is_raster() && (workbench.state.layer.is_image() || moving_))
      refresh_raster(workbench, into);
    else
      into.refresh(workbench, {display, workbench.state.layer, exposure_, scale});
    failure_.clear();
  } catch (const std::exception& error) {
    raster_done_ = true; // there will not be more of it
    if (failure_ != error.what()) workbench.say(error.what(), true);
    failure_ = error.what();
  }
}

void ImagePanel::refresh_raster(Workbench& workbench, ShownPicture& into) {
  if (raster_of_ != workbench.scene()) {
    raster_of_ = workbench.scene();
    raster_camera_.reset();
    raster_.reset();
    raster_ = std::make_unique<RasterPreview>(workbench.scene()->scene());
  }
  if (!raster_) return; // it failed, and that has been said
  if (raster_camera_ != workbench.camera()) {
    raster_camera_ = workbench.camera();
    raster_->start(*raster_camera_, workbench.scene()->scene().image_size);
    raster_done_ = false;
  }
  raster_shown_ = true;
  if (!raster_done_) {
    raster_done_ = raster_->advance(moving_ ? raster_budget_moving : raster_budget);
    raster_image_ = raster_->radiance();
    ++raster_version_;
    if (!exposure_final_ && (!exposure_ || raster_done_)) {
      exposure_ = automatic_exposure(raster_image_);
      exposure_final_ = raster_done_;
    }
  }
  into.refresh(raster_image_, workbench.scene()->scene().image_size, raster_version_,
               workbench.state.colours, exposure_);
}

void ImagePanel::remember_exposure(Workbench& workbench) {
  if (exposure_of_ != workbench.scene()) {
    exposure_of_ = workbench.scene();
    exposure_.reset();
    exposure_final_ = false;
  }
  if (workbench.state.display.is_raster() || moving_) return; // see refresh_raster()
  const LayerSources sources = workbench.sources(workbench.state.display, layers::image);
  // The first pass gives a first guess, the whole picture the last one.
  const bool complete = sources.frame->complete();
  if (exposure_final_ || (exposure_ && !complete) || sources.frame->share() < 1.0 / 256) return;
  exposure_ = coloured(layers::image, layer_values(layers::image, sources), {}).exposure;
  exposure_final_ = complete;
}

// ---- the mouse

void ImagePanel::handle_mouse(Workbench& workbench) {
  const ImGuiIO& io = ImGui::GetIO();
  const glm::uvec2 size = shown_.coloured().size;
  hovered_ =
      ImGui::IsItemHovered() ? pixel_at(view_, area_, to_dvec(io.MousePos), size) : std::nullopt;
  if (ImGui::IsItemHovered()) handle_zoom(workbench);
  const double split_x = area_.origin.x + workbench.state.split_at * area_.size.x;
  if (workbench.state.split && ImGui::IsItemClicked() && std::abs(io.MousePos.x - split_x) < 6)
    dragging_split_ = true;
  if (dragging_split_) {
    workbench.state.split_at =
        float(std::clamp((io.MousePos.x - area_.origin.x) / area_.size.x, 0.0, 1.0));
    dragging_split_ = ImGui::IsItemActive();
  } else if (is_dragged(ImGuiMouseButton_Left)) {
    workbench.state.image = panned(view_, to_dvec(io.MouseDelta));
  } else if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
             hovered_) {
    click(workbench);
  }
  move_camera(workbench);
}

void ImagePanel::click(Workbench& workbench) {
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
  if (std::hypot(moved.x, moved.y) > 3) return;
  workbench.state.pixel = hovered_;
  workbench.state.step.reset();
  workbench.state.node.reset();
}

void ImagePanel::handle_zoom(Workbench& workbench) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0 || io.KeyCtrl) return;
  workbench.state.image = zoomed(view_, area_, to_dvec(io.MousePos), std::pow(1.2, io.MouseWheel));
}

void ImagePanel::move_camera(Workbench& workbench) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool orbits = is_dragged(ImGuiMouseButton_Right);
  const bool pans = is_dragged(ImGuiMouseButton_Middle);
  const bool dollies = ImGui::IsItemHovered() && io.KeyCtrl && io.MouseWheel != 0;
  if (!orbits && !pans && !dollies) {
    moving_.reset();
    workbench.holds_pictures = false;
    return;
  }
  if (!moving_) {
    const Camera& camera = workbench.camera();
    moving_ = OrbitCamera::from_camera(camera, camera.target);
  }
  if (orbits)
    moving_->orbit(-camera_radians_per_pixel * io.MouseDelta.x,
                   camera_radians_per_pixel * io.MouseDelta.y);
  if (pans) moving_->pan(to_dvec(io.MouseDelta), glm::uvec2(area_.size));
  if (dollies) moving_->dolly(std::pow(0.9, io.MouseWheel));
  const Camera camera = moving_->to_camera();
  try {
    (void)PinholeView(camera, glm::uvec2(1));
  } catch (const InputError&) { // too near or too far for floats: no farther
    moving_.reset();
    return;
  }
  workbench.state.camera = camera;
  workbench.state.pixel.reset();
  workbench.holds_pictures = true;
}

// ---- drawing

void ImagePanel::draw_pictures(Workbench& workbench) {
  const glm::dvec2 size(shown_.coloured().size);
  if (size.x == 0) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  glm::dvec2 corner = to_screen(view_, area_, {0, 0});
  if (view_.zoom == 1) corner = glm::floor(corner + 0.5); // pixels upon pixels
  const ImVec2 lo = to_imgui(corner), hi = to_imgui(corner + size * view_.zoom);
  const ImVec2 end = to_imgui(area_.origin + area_.size);
  if (!workbench.state.split || flipped_) {
    list->AddImage(texture_id(shown_.texture()), lo, hi);
    return;
  }
  const float x = float(area_.origin.x + workbench.state.split_at * area_.size.x);
  list->PushClipRect(to_imgui(area_.origin), {x, end.y}, true);
  list->AddImage(texture_id(shown_.texture()), lo, hi);
  list->PopClipRect();
  list->PushClipRect({x, float(area_.origin.y)}, end, true);
  list->AddImage(texture_id(compared_.texture()), lo, hi);
  list->PopClipRect();
}

void ImagePanel::draw_pixel_values(Workbench& workbench) {
  if (view_.zoom < zoom_for_values) return;
  const glm::uvec2 size = shown_.coloured().size;
  const glm::dvec2 lo = to_image(view_, area_, area_.origin);
  const glm::dvec2 hi = to_image(view_, area_, area_.origin + area_.size);
  const auto first = glm::uvec2(glm::max(glm::floor(lo), glm::dvec2(0)));
  const auto last = glm::min(glm::uvec2(glm::max(glm::ceil(hi), glm::dvec2(0))), size);
  const bool split = workbench.state.split && !flipped_;
  const double split_x = area_.origin.x + workbench.state.split_at * area_.size.x;
  for (unsigned y = first.y; y < last.y; ++y)
    for (unsigned x = first.x; x < last.x; ++x) {
      const glm::dvec2 at = to_screen(view_, area_, glm::dvec2(x, y) + 0.5);
      const bool right = split && at.x > split_x;
      const ShownPicture& shown = right ? compared_ : shown_;
      draw_value_in_pixel(shown, std::size_t(y) * size.x + x, at, float(view_.zoom));
    }
}

void ImagePanel::draw_block(const Workbench& workbench) {
  const auto& result = workbench.inspection();
  // That of an earlier pixel may still be there.
  if (!result || !workbench.state.pixel || result->key.pixel != *workbench.state.pixel) return;
  if (result->key.frame.method != workbench.state.display.method()) return;
  const std::vector<PixelEdge> outline = outline_of(result->inspection.block);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto at = [&](glm::uvec2 corner) {
    return to_imgui(to_screen(view_, area_, glm::dvec2(corner)));
  };
  for (const PixelEdge& e : outline) list->AddLine(at(e.from), at(e.to), IM_COL32(0, 0, 0, 255), 3);
  for (const PixelEdge& e : outline) list->AddLine(at(e.from), at(e.to), block_colour, 1.5F);
}

void ImagePanel::draw_selection(const Workbench& workbench) {
  if (!workbench.state.pixel) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const glm::dvec2 pixel(*workbench.state.pixel);
  glm::dvec2 lo = to_screen(view_, area_, pixel), hi = to_screen(view_, area_, pixel + 1.0);
  constexpr double least = 9; // seen at any zoom
  if (hi.x - lo.x < least) {
    const glm::dvec2 middle = 0.5 * (lo + hi);
    lo = middle - least / 2;
    hi = middle + least / 2;
  }
  list->AddRect(to_imgui(lo - 1.0), to_imgui(hi + 1.0), IM_COL32(0, 0, 0, 255), 0, 0, 3);
  list->AddRect(to_imgui(lo - 1.0), to_imgui(hi + 1.0), selection_colour, 0, 0, 1.5F);
}

void ImagePanel::draw_split(Workbench& workbench) {
  if (!workbench.state.split || flipped_) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = float(area_.origin.x + workbench.state.split_at * area_.size.x);
  const float top = float(area_.origin.y), bottom = top + float(area_.size.y);
  list->AddLine({x, top}, {x, bottom}, IM_COL32(0, 0, 0, 255), 4);
  list->AddLine({x, top}, {x, bottom}, IM_COL32(255, 255, 255, 255), 2);
  const char* left = name_of(workbench.state.display);
  const float width = ImGui::CalcTextSize(left).x;
  draw_label({x - width - 14, top + 6}, left);
  draw_label({x + 8, top + 6}, name_of(workbench.state.compared));
}

void ImagePanel::draw_tooltip(Workbench& workbench) {
  if (!hovered_ || ImGui::IsItemActive()) return;
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(pixel_text(workbench, *hovered_).c_str());
  ImGui::EndTooltip();
}

} // namespace lightcuts::viz
