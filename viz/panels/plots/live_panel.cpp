// SPDX-License-Identifier: MIT
#include <viz/panels/plots/live_panel.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

void threshold(Workbench& workbench) {
  ShadingSettings& s = workbench.state.shading;
  bool automatic = !s.threshold;
  const float shown = s.threshold.value_or(workbench.scene()->default_threshold());
  float percent = 100 * shown;
  if (ImGui::SliderFloat("threshold", &percent, 0.01F, 100, "%.3g %%",
                         ImGuiSliderFlags_Logarithmic))
    s.threshold = std::clamp(percent, 0.0F, 1e6F) / 100;
  tooltip("A cluster is refined until its error bound is at most this share of the pixel's total, "
          "in every channel: bound <= threshold x total. Ctrl+click to type.");
  if (ImGui::Checkbox("by scene", &automatic)) {
    if (automatic)
      s.threshold.reset();
    else
      s.threshold = shown;
  }
  tooltip("The threshold that gives this kind of scene a mean error of 1 % or less.");
}

void cut_size(Workbench& workbench) {
  ShadingSettings& s = workbench.state.shading;
  int most = int(std::min<std::uint32_t>(s.max_cut, 1'000'000));
  if (ImGui::SliderInt("maximum cut", &most, 1, 100'000, "%d", ImGuiSliderFlags_Logarithmic))
    s.max_cut = std::uint32_t(std::max(most, 1));
  tooltip("Refinement ends at so many clusters, whatever their bounds.");
}

template <class Enum, std::size_t n>
void choice(const char* label, Enum& value, const char* const (&names)[n],
            const char* const (&help)[n]) {
  if (!ImGui::BeginCombo(label, names[std::size_t(value)])) return;
  for (std::size_t i = 0; i < n; ++i) {
    if (ImGui::Selectable(names[i], std::size_t(value) == i)) value = Enum(i);
    tooltip(help[i]);
  }
  ImGui::EndCombo();
}

void rules(Workbench& workbench) {
  ShadingSettings& s = workbench.state.shading;
  choice("criterion", s.rules.bound, {"joint bound", "no specular bound", "product bound"},
         {"The exact maximum of n.l / d^2 over the cluster's box, in one.",
          "The same, with the glossy lobe taken at its peak.",
          "Maxima of n.l and of 1 / d^2 apart, as published: looser."});
  tooltip("What error bound the threshold is compared with.");
  choice("estimate", s.rules.estimate,
         {"centroid, second moment", "representative, scaled", "representative, unscaled"},
         {"Material and geometry at the intensity centroid, corrected by the second moment; one "
          "shadow ray.",
          "The representative's contribution x cluster intensity / its own, as published.",
          "The representative alone: too dark."});
  tooltip("What a cluster is taken to contribute.");
  bool always = s.tree_use == TreeUse::always;
  if (ImGui::Checkbox("use the tree even where it does not pay", &always))
    s.tree_use = always ? TreeUse::always : TreeUse::automatic;
  tooltip(
      "With few lights, cuts have most of them and a cluster costs more than a light: "
      "lightcuts sums all lights there. Criteria and estimates other than the first ones always "
      "use the tree.");
}

void whether_tree_is_used(Workbench& workbench) {
  const auto frame = workbench.sources(methods::lightcuts, layers::image).frame;
  const auto features = frame->features();
  if (!features || features->tree) return;
  ImGui::PushTextWrapPos();
  ImGui::TextColored(quiet_text, "%s",
                     fmt::format("The tree is left out: cuts would have {:.0f} of {} lights and "
                                 "take {:.1f} times as long as all lights.",
                                 features->pilot_cut_size, workbench.scene()->scene().lights.size(),
                                 features->pilot_cost_of_cuts / features->pilot_cost_of_sums)
                         .c_str());
  ImGui::PopTextWrapPos();
}

void clamp(Workbench& workbench) {
  SceneRequest& open = workbench.state.open;
  const float own = workbench.scene()->scene().lights.min_distance();
  bool clamped = open.min_distance.has_value();
  float distance = open.min_distance.value_or(own > 0 ? own : 0.1F);
  if (ImGui::Checkbox("clamp", &clamped)) {
    if (clamped)
      open.min_distance = distance;
    else
      open.min_distance.reset();
  }
  tooltip("Distances to lights count as at least this: 1 / max(d^2, d_min^2). Against bright spots "
          "around virtual lights. Builds the tree again.");
  ImGui::SameLine();
  ImGui::BeginDisabled(!clamped);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 10);
  ImGui::SliderFloat("metres", &distance, 1e-3F, 10, "%.3g", ImGuiSliderFlags_Logarithmic);
  if (ImGui::IsItemDeactivatedAfterEdit()) open.min_distance = std::clamp(distance, 1e-6F, 1e6F);
  ImGui::EndDisabled();
}

void tree(Workbench& workbench) {
  choice("builder", workbench.state.open.builder, {"greedy", "locally ordered"},
         {"The cheapest of all pairs of clusters merges each time, as Walter et al. have it.",
          "Pairs that are near on a Morton curve merge, many at once: sooner built, and with many "
          "lights the better tree."});
  tooltip("How lights are clustered: by least intensity x (diagonal^2 + c^2 (1 - cos beta)^2). "
          "Builds the tree again.");
  if (workbench.opening()) {
    ImGui::TextColored(quiet_text, "being built ...");
  } else {
    const double seconds = workbench.scene()->build_seconds();
    const bool is_long = seconds >= 0.1;
    ImGui::TextColored(quiet_text, "built in %.3g %s", is_long ? seconds : 1000 * seconds,
                       is_long ? "s" : "ms");
  }
  int tree_seed = int(workbench.state.open.tree_seed);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
  if (ImGui::InputInt("seed of the tree", &tree_seed, 1, 10) && tree_seed >= 0)
    workbench.state.open.tree_seed = std::uint64_t(tree_seed);
  tooltip("Clusters' representatives are drawn by intensity, by this seed.");
}

void draws(Workbench& workbench) {
  int seed = int(workbench.state.shading.seed);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
  if (ImGui::InputInt("seed of the draws", &seed, 1, 10) && seed >= 0)
    workbench.state.shading.seed = std::uint64_t(seed);
  tooltip("Of the stochastic methods: another seed, other noise.");
}

} // namespace

void draw_live_panel(Workbench& workbench) {
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.62F);
  threshold(workbench);
  cut_size(workbench);
  ImGui::Separator();
  ImGui::TextColored(quiet_text, "of the method lightcuts");
  rules(workbench);
  whether_tree_is_used(workbench);
  ImGui::Separator();
  if (workbench.scene()->counterexample()) {
    ImGui::TextColored(quiet_text, "a counterexample has its own lights and tree");
  } else {
    clamp(workbench);
    tree(workbench);
  }
  draws(workbench);
  if (ImGui::Button("as by default")) {
    workbench.state.shading = {};
    workbench.state.open.tree_seed = 1;
    workbench.state.open.builder = Builder::greedy;
    workbench.state.open.min_distance.reset();
  }
  ImGui::PopItemWidth();
}

} // namespace lightcuts::viz
