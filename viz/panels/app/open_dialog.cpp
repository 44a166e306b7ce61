// SPDX-License-Identifier: MIT
#include <viz/panels/app/open_dialog.h>

#include <algorithm>

#include <imgui.h>
#include <imgui_stdlib.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/io/scene_files.h>

#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

constexpr const char* title = "Open a scene";

} // namespace

void OpenDialog::open() {
  opening_ = true;
  std::error_code error;
  if (folder_.empty()) folder_ = std::filesystem::current_path(error);
  list_folder();
}

void OpenDialog::list_folder() {
  folders_.clear();
  files_.clear();
  problem_.clear();
  std::error_code error;
  const auto skip = std::filesystem::directory_options::skip_permission_denied;
  for (std::filesystem::directory_iterator i(folder_, skip, error), end; !error && i != end;
       i.increment(error)) {
    std::error_code ignored; // a broken link is neither a folder nor a file
    if (i->path().filename().string().starts_with('.')) continue;
    if (i->is_directory(ignored))
      folders_.push_back(i->path());
    else if (is_scene_file(i->path()))
      files_.push_back(i->path());
  }
  if (error) problem_ = folder_.string() + ": " + error.message();
  std::sort(folders_.begin(), folders_.end());
  std::sort(files_.begin(), files_.end());
}

std::optional<std::string> OpenDialog::draw_builtin() {
  std::optional<std::string> chosen;
  ImGui::TextColored(quiet_text, "built-in");
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (ImGui::Selectable(scene.name.c_str())) chosen = scene.name;
    tooltip(scene.description.c_str());
  }
  return chosen;
}

std::optional<std::string> OpenDialog::draw_recent(const AppSettings& settings) {
  std::optional<std::string> chosen;
  if (!settings.recent.empty()) ImGui::TextColored(quiet_text, "recent");
  for (const std::string& scene : settings.recent)
    if (ImGui::Selectable((scene + "##recent").c_str())) chosen = scene;
  return chosen;
}

std::optional<std::string> OpenDialog::draw_files() {
  std::optional<std::string> chosen;
  ImGui::TextColored(quiet_text, "%s", folder_.string().c_str());
  ImGui::BeginChild("files", {0, ImGui::GetFontSize() * 16}, true);
  std::optional<std::filesystem::path> enter;
  if (folder_.has_parent_path() && ImGui::Selectable("..")) enter = folder_.parent_path();
  for (const auto& folder : folders_)
    if (ImGui::Selectable((folder.filename().string() + "/").c_str())) enter = folder;
  for (const auto& file : files_)
    if (ImGui::Selectable(file.filename().string().c_str())) chosen = file.string();
  if (!problem_.empty()) ImGui::TextColored(violation_text, "%s", problem_.c_str());
  ImGui::EndChild();
  if (enter) {
    folder_ = *enter;
    list_folder();
  }
  return chosen;
}

std::optional<std::string> OpenDialog::draw(const AppSettings& settings) {
  if (opening_) ImGui::OpenPopup(title);
  opening_ = false;
  ImGui::SetNextWindowSize({ImGui::GetFontSize() * 46, 0});
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return {};
  std::optional<std::string> chosen;
  ImGui::TextWrapped("A built-in scene with its parameters (cloud?lights=20000), a %s file, or a "
                     "counterexample.",
                     scene_extensions_text().c_str());
  ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 6);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##typed", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if ((ImGui::Button("Open") || entered) && !typed_.empty()) chosen = typed_;
  ImGui::Columns(2, nullptr, false);
  if (const auto builtin = draw_builtin()) chosen = builtin;
  if (const auto recent = draw_recent(settings)) chosen = recent;
  ImGui::NextColumn();
  if (const auto file = draw_files()) chosen = file;
  ImGui::Columns(1);
  if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) || chosen)
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return chosen;
}

} // namespace lightcuts::viz
