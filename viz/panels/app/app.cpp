// SPDX-License-Identifier: MIT
#include <viz/panels/app/app.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <lightcuts/render/files/text.h>

#include <viz/model/layers/all_layers.h>
#include <viz/model/saved_view.h>
#include <viz/panels/app/overlays.h>
#include <viz/panels/app/status_line.h>
#include <viz/panels/app/toolbar.h>
#include <viz/panels/cut/counterexample_panel.h>
#include <viz/panels/cut/refinement_panel.h>
#include <viz/panels/gui/drawing.h>
#include <viz/panels/picture/pixel_panel.h>
#include <viz/panels/plots/live_panel.h>

namespace lightcuts::viz {
namespace {

constexpr float splitter = 6;

/// A bar that changes a share when it is dragged. length: of what is shared, pixels.
void draw_splitter(const char* id, bool upright, float length, float& share) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  ImGui::InvisibleButton(id, upright ? ImVec2(splitter, left.y) : ImVec2(left.x, splitter));
  const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (hot) ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActive() && length > 0) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    share = std::clamp(share - (upright ? by.x : by.y) / length, 0.1F, 0.8F);
  }
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled(
      lo, hi, ImGui::GetColorU32(hot ? ImGuiCol_SeparatorHovered : ImGuiCol_Separator, 0.5F));
}

} // namespace

App::App(AppSettings settings, std::filesystem::path output)
    : settings_(std::move(settings)), output_(std::move(output)) {
  workbench_.state.colours.map = settings_.colour_map;
}

bool App::settled() const { return !workbench_.busy() && image_.raster_complete(); }

void App::frame() {
  const KeyRequests requests = handle_keys(workbench_);
  workbench_.wants_reference = requests.flip;
  image_.flip(requests.flip);
  handle_requests(requests);
  workbench_.update();
  adopt_scene();
  draw_menu();
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport.WorkPos);
  ImGui::SetNextWindowSize(viewport.WorkSize);
  ImGui::Begin("all", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse);
  if (scene_) {
    const ImVec2 size = ImGui::GetContentRegionAvail();
    const float left = std::floor((1 - settings_.details_share) * size.x);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    draw_left(left, size.y);
    ImGui::SameLine();
    draw_splitter("details", true, size.x, settings_.details_share);
    ImGui::SameLine();
    ImGui::PopStyleVar();
    draw_right();
  } else {
    draw_welcome();
  }
  ImGui::End();
  draw_messages(workbench_);
  draw_help(shows_help_);
  if (const auto chosen = open_dialog_.draw(settings_)) workbench_.open(*chosen);
  settings_.colour_map = workbench_.state.colours.map;
}

void App::handle_requests(const KeyRequests& requests) {
  if (requests.open) open_dialog_.open();
  if (requests.help) shows_help_ = !shows_help_;
  if (requests.quit) quits_ = true;
  if (requests.save) save();
}

void App::adopt_scene() {
  if (scene_ == workbench_.scene()) return;
  scene_ = workbench_.scene();
  icicle_ = std::make_unique<Icicle>(scene_->topology());
  icicle_state_ = {};
  icicle_state_.view.row_height = std::round(1.3F * ImGui::GetFontSize());
  cluster_state_ = {};
  cut_ = {};
  cut_of_.reset();
  cut_size_ = 0;
  settings_.remember(scene_->request().spec);
  if (scene_->counterexample()) wanted_tab_ = Tab::counterexample;
}

void App::save() {
  if (!scene_) return;
  const std::string name =
      fmt::format("{}-{}-{}", scene_->scene().name, name_of(workbench_.state.display),
                  workbench_.state.layer->name);
  std::string file;
  for (const char c : name)
    file += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' ? c : '-';
  try {
    save_view(workbench_, image_.shown().coloured(), image_.shown().values(), output_, file);
    workbench_.say(fmt::format("saved {}/{}.png, .exr and .json", output_.string(), file));
  } catch (const std::exception& error) {
    workbench_.say(error.what(), true);
  }
}

void App::draw_menu() {
  if (!ImGui::BeginMainMenuBar()) return;
  draw_file_menu();
  draw_view_menu();
  if (ImGui::MenuItem("Help")) shows_help_ = true;
  if (scene_ && workbench_.opening()) { // before what may be too long for the window
    if (ImGui::SmallButton("Cancel")) workbench_.cancel_opening();
    ImGui::TextUnformatted("opening ...");
  }
  if (scene_) {
    const Scene& scene = scene_->scene();
    ImGui::TextColored(quiet_text, "   %s: %s, %s, %u x %u", scene.name.c_str(),
                       counted(scene.lights.size(), "light").c_str(),
                       counted(scene.mesh.triangles.size(), "triangle").c_str(), scene.image_size.x,
                       scene.image_size.y);
  }
  ImGui::EndMainMenuBar();
}

void App::draw_file_menu() {
  if (!ImGui::BeginMenu("File")) return;
  if (ImGui::MenuItem("Open ...", "Ctrl+O")) open_dialog_.open();
  if (ImGui::BeginMenu("Recent", !settings_.recent.empty())) {
    std::optional<std::string> chosen;
    for (const std::string& scene : settings_.recent)
      if (ImGui::MenuItem(scene.c_str())) chosen = scene;
    if (chosen) workbench_.open(*chosen);
    ImGui::EndMenu();
  }
  if (ImGui::MenuItem("Save view", "Ctrl+S", false, scene_ != nullptr)) save();
  if (ImGui::MenuItem("Quit", "Ctrl+Q")) quits_ = true;
  ImGui::EndMenu();
}

void App::draw_view_menu() {
  if (!ImGui::BeginMenu("View")) return;
  ViewState& s = workbench_.state;
  for (const DisplayMethod& display : all_displays)
    if (ImGui::MenuItem(name_of(display), nullptr, display == s.display)) s.display = display;
  ImGui::Separator();
  for (const Layer layer : all_layers)
    if (ImGui::MenuItem(layer->title, nullptr, layer == s.layer)) s.layer = layer;
  ImGui::Separator();
  ImGui::MenuItem("Split", "S", &s.split);
  if (ImGui::MenuItem("Fit", "F")) s.image.fits = true;
  if (ImGui::MenuItem("The scene's camera", "R")) s.camera.reset();
  ImGui::EndMenu();
}

void App::draw_left(float width, float height) {
  ImGui::BeginChild("left", {width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8, 4});
  const float tree = std::floor(settings_.tree_share * height);
  draw_toolbar(workbench_.state);
  const float status = ImGui::GetTextLineHeightWithSpacing() + 2;
  draw_image_row(std::max(40.0F, ImGui::GetContentRegionAvail().y - tree - splitter - status - 8));
  draw_status(workbench_, image_);
  ImGui::PopStyleVar();
  draw_splitter("tree", false, height, settings_.tree_share);
  draw_tree(ImGui::GetContentRegionAvail().y);
  ImGui::EndChild();
}

void App::draw_image_row(float height) {
  const float width = ImGui::GetFontSize() * (workbench_.state.layer.is_image() ? 3.4F : 9.4F);
  constexpr auto still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::BeginChild("image", {ImGui::GetContentRegionAvail().x - width - 6, height}, false, still);
  image_.draw(workbench_);
  ImGui::EndChild();
  ImGui::SameLine(0, 6);
  ImGui::BeginChild("legend", {width, height}, false, still);
  legend_.draw(workbench_, image_.shown());
  ImGui::EndChild();
}

void App::draw_tree(float height) {
  ImGui::BeginChild("tree", {0, height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (cut_of_ != workbench_.inspection()) {
    cut_of_ = workbench_.inspection();
    ++revision_;
    std::vector<std::uint32_t> nodes;
    if (cut_of_)
      for (const ClusterRow& row : cut_of_->inspection.clusters) nodes.push_back(row.node);
    cut_size_ = std::uint32_t(nodes.size());
    cut_ = icicle_->cut(nodes);
  }
  const IcicleEvents events =
      draw_icicle("icicle",
                  {*icicle_,
                   scene_->topology(),
                   cut_,
                   cut_size_,
                   workbench_.state.node,
                   hovered_node_,
                   {},
                   [this](std::uint32_t node) { return workbench_.row(node); }},
                  icicle_state_, ImGui::GetContentRegionAvail());
  if (events.clicked) workbench_.state.node = events.clicked;
  ImGui::EndChild();
}

void App::draw_right() {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6, 2});
  ImGui::BeginChild("right", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  draw_pixel_panel(workbench_);
  ImGui::Spacing();
  draw_tabs();
  ImGui::EndChild();
}

void App::draw_tabs() {
  hovered_node_.reset();
  if (!ImGui::BeginTabBar("tabs")) return;
  const auto tab = [&](Tab which, const char* name, auto&& draw) {
    const auto flags =
        wanted_tab_ == which ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
    if (!ImGui::BeginTabItem(name, nullptr, flags)) return;
    ImGui::BeginChild("tab");
    draw();
    ImGui::EndChild();
    ImGui::EndTabItem();
  };
  if (scene_->counterexample())
    tab(Tab::counterexample, "Counterexample", [&] { draw_counterexample_panel(workbench_); });
  tab(Tab::cut, "Cut", [&] { draw_cut_tab(); });
  tab(Tab::why, "Why this cut?", [&] { draw_refinement_panel(workbench_); });
  tab(Tab::scene, "Scene", [&] { scene_panel_.draw(workbench_); });
  tab(Tab::plots, "Plots", [&] { plots_.draw(workbench_); });
  tab(Tab::live, "Live", [&] { draw_live_panel(workbench_); });
  wanted_tab_.reset();
  ImGui::EndTabBar();
}

void App::draw_cut_tab() {
  const auto& result = workbench_.inspection();
  if (!result || result->inspection.clusters.empty()) {
    ImGui::TextColored(quiet_text, "The clusters of the selected pixel's cut.");
    return;
  }
  const ClusterEvents events =
      draw_clusters("clusters", {result->inspection.clusters, revision_, workbench_.state.node},
                    cluster_state_, {0, 0});
  if (events.clicked) workbench_.state.node = events.clicked;
  hovered_node_ = events.hovered;
}

void App::draw_welcome() {
  const ImVec2 size = ImGui::GetContentRegionAvail();
  ImGui::SetCursorPos({size.x * 0.35F, size.y * 0.4F});
  if (workbench_.opening()) {
    ImGui::Text("Opening %s ...", workbench_.state.open.spec.c_str());
    ImGui::SetCursorPosX(size.x * 0.35F);
    if (ImGui::Button("Cancel")) workbench_.cancel_opening();
    return;
  }
  ImGui::TextUnformatted("Drop a scene here, or press Ctrl+O.");
}

} // namespace lightcuts::viz
