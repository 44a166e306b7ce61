// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <viz/model/cut/icicle.h>
#include <viz/model/state/app_settings.h>
#include <viz/model/workbench.h>
#include <viz/panels/app/open_dialog.h>
#include <viz/panels/app/shortcuts.h>
#include <viz/panels/cut/cluster_panel.h>
#include <viz/panels/cut/icicle_panel.h>
#include <viz/panels/cut/scene_panel.h>
#include <viz/panels/picture/image_panel.h>
#include <viz/panels/picture/legend.h>
#include <viz/panels/plots/plots_panel.h>

namespace lightcuts::viz {

/// The panels at the right.
enum class Tab { cut, why, scene, plots, live, counterexample };

/// The whole window. Made, used and destroyed where an OpenGL and an ImGui context are current.
class App {
public:
  /// settings.window_size is not used here. output: where Ctrl+S saves.
  App(AppSettings settings, std::filesystem::path output);

  /// Draws everything, and acts on mouse and keys: between ImGui::NewFrame() and ImGui::Render().
  void frame();

  [[nodiscard]] Workbench& workbench() { return workbench_; }
  [[nodiscard]] AppSettings& settings() { return settings_; }
  [[nodiscard]] const ImagePanel& image() const { return image_; }
  [[nodiscard]] const Legend& legend() const { return legend_; }
  /// Shows the panel as if it had been chosen by a click.
  void show(Tab tab) { wanted_tab_ = tab; }
  /// Opens a file that was dropped on the window.
  void drop(const std::string& file) { workbench_.open(file); }
  /// Whether all that is asked for is shown: nothing runs in the background.
  [[nodiscard]] bool settled() const;
  [[nodiscard]] bool wants_to_quit() const { return quits_; }

private:
  void handle_requests(const KeyRequests& requests);
  void draw_menu();
  void draw_file_menu();
  void draw_view_menu();
  void draw_left(float width, float height);
  void draw_image_row(float height);
  void draw_tree(float height);
  void draw_right();
  void draw_tabs();
  void draw_cut_tab();
  void draw_welcome();
  void adopt_scene();
  void save();

  AppSettings settings_;
  std::filesystem::path output_;
  Workbench workbench_;
  ImagePanel image_;
  Legend legend_;
  OpenDialog open_dialog_;
  ScenePanel scene_panel_;
  PlotsPanel plots_;
  std::shared_ptr<const OpenedScene> scene_; ///< for which icicle_ was made
  std::unique_ptr<Icicle> icicle_;
  IciclePanelState icicle_state_;
  std::shared_ptr<const InspectionResult> cut_of_; ///< for which cut_ was made
  IcicleCut cut_;
  std::uint32_t cut_size_ = 0;
  std::uint64_t revision_ = 0;                ///< of the rows
  std::optional<std::uint32_t> hovered_node_; ///< in the table
  ClusterPanelState cluster_state_;
  std::optional<Tab> wanted_tab_;
  bool shows_help_ = false, quits_ = false;
};

} // namespace lightcuts::viz
