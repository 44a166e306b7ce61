// SPDX-License-Identifier: MIT
#include <viz/panels/app/toolbar.h>

#include <imgui.h>

#include <viz/model/layers/all_layers.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

/// A combo of all displays; what it is called, on hovering.
void display_combo(const char* id, DisplayMethod& display) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11);
  if (!ImGui::BeginCombo(id, name_of(display))) {
    tooltip(meaning_of(display));
    return;
  }
  for (const DisplayMethod& d : all_displays) {
    if (ImGui::Selectable(name_of(d), d == display)) display = d;
    tooltip(meaning_of(d));
  }
  ImGui::EndCombo();
}

void layer_combo(Layer& layer) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
  if (!ImGui::BeginCombo("##layer", layer->title)) {
    tooltip(layer->meaning);
    return;
  }
  for (const Layer l : all_layers) {
    if (ImGui::Selectable(l->title, l == layer)) layer = l;
    tooltip(l->meaning);
  }
  ImGui::EndCombo();
}

void colour_map_combo(ColourMap& map) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
  if (!ImGui::BeginCombo("##map", name_of(map))) return;
  for (const ColourMap m : all_colour_maps)
    if (ImGui::Selectable(name_of(m), m == map)) map = m;
  ImGui::EndCombo();
}

} // namespace

void draw_toolbar(ViewState& s) {
  display_combo("##method", s.display);
  ImGui::SameLine();
  layer_combo(s.layer);
  ImGui::SameLine();
  ImGui::Checkbox("split", &s.split);
  tooltip("Two methods in one image; drag the line between them.");
  if (s.split) {
    ImGui::SameLine();
    display_combo("##compared", s.compared);
  }
  if (s.layer.is_image()) return;
  ImGui::SameLine();
  colour_map_combo(s.colours.map);
  ImGui::SameLine();
  if (ImGui::Checkbox("log", &s.colours.logarithmic)) s.colours.automatic_range = true;
  tooltip("Equal ratios, not equal differences, get equal steps of colour.");
  if (s.colours.automatic_range) return;
  ImGui::SameLine();
  if (ImGui::SmallButton("auto range")) s.colours.automatic_range = true;
}

} // namespace lightcuts::viz
