// SPDX-License-Identifier: MIT
#include <viz/panels/app/overlays.h>

#include <algorithm>

#include <imgui.h>

#include <viz/panels/app/shortcuts.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {

void draw_messages(Workbench& workbench) {
  if (workbench.messages().empty()) return;
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(
      {viewport.WorkPos.x + viewport.WorkSize.x / 2, viewport.WorkPos.y + viewport.WorkSize.y - 12},
      ImGuiCond_Always, {0.5F, 1});
  ImGui::SetNextWindowSize({std::min(viewport.WorkSize.x - 40, ImGui::GetFontSize() * 60), 0});
  ImGui::Begin("messages", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  constexpr std::size_t most = 6;
  const auto& all = workbench.messages();
  ImGui::PushTextWrapPos();
  for (std::size_t i = all.size() > most ? all.size() - most : 0; i < all.size(); ++i)
    if (all[i].error)
      ImGui::TextColored(violation_text, "%s", all[i].text.c_str());
    else
      ImGui::TextUnformatted(all[i].text.c_str());
  ImGui::PopTextWrapPos();
  if (ImGui::SmallButton("OK")) workbench.clear_messages();
  ImGui::End();
}

void draw_help(bool& shown) {
  if (!shown) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::Begin("Shortcuts", &shown,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::BeginTable("shortcuts", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const Shortcut& s : all_shortcuts()) {
      ImGui::TableNextColumn();
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(selection_colour), "%s", s.keys);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(s.effect);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

} // namespace lightcuts::viz
