// SPDX-License-Identifier: MIT
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {

void draw_label(const ImVec2& at, const char* text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text);
  list->AddRectFilled({at.x - 3, at.y - 2}, {at.x + size.x + 3, at.y + size.y + 2},
                      IM_COL32(0, 0, 0, 170), 3);
  list->AddText(at, IM_COL32(255, 255, 255, 255), text);
}

void tooltip(const char* text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

} // namespace lightcuts::viz
