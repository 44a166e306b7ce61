// SPDX-License-Identifier: MIT
#include <viz/panels/app/shortcuts.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <imgui.h>

#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

constexpr std::array shortcuts{
    Shortcut{"Tab, Shift+Tab", "next, previous method"},
    Shortcut{"PgDn, PgUp", "next, previous layer"},
    Shortcut{"Space (hold)", "show the reference"},
    Shortcut{"S", "split: two methods in one image"},
    Shortcut{"L", "colours linear or logarithmic"},
    Shortcut{"click", "select the pixel"},
    Shortcut{"arrows", "move the selected pixel (Shift: by 10)"},
    Shortcut{", and .", "one refinement back, on"},
    Shortcut{"wheel", "zoom at the cursor"},
    Shortcut{"drag", "move the image"},
    Shortcut{"F", "fit the image into its area"},
    Shortcut{"1", "one screen pixel per pixel"},
    Shortcut{"right drag", "orbit the camera"},
    Shortcut{"middle drag", "move the camera sideways"},
    Shortcut{"Ctrl+wheel", "move the camera nearer, away"},
    Shortcut{"R", "the scene's own camera"},
    Shortcut{"tree: wheel, drag", "zoom, move; Shift+wheel: up and down; double click: all"},
    Shortcut{"colour bar: drag", "the range, upper or lower end; double click: automatic"},
    Shortcut{"Ctrl+click", "type a slider's number"},
    Shortcut{"Ctrl+O", "open a scene or counterexample; files can be dropped, too"},
    Shortcut{"Ctrl+S", "save the view: PNG, EXR with all layers, JSON"},
    Shortcut{"Esc", "let go of the cluster, then of the pixel"},
    Shortcut{"?", "this list"},
    Shortcut{"Ctrl+Q", "quit"},
};

bool pressed(int key, bool repeats = false) { return ImGui::IsKeyPressed(key, repeats); }
bool pressed_named(ImGuiKey key, bool repeats = false) {
  return pressed(ImGui::GetKeyIndex(key), repeats);
}

bool typed(unsigned character) {
  const auto& queue = ImGui::GetIO().InputQueueCharacters;
  return std::find(queue.begin(), queue.end(), ImWchar(character)) != queue.end();
}

void move_pixel(Workbench& workbench) {
  ViewState& s = workbench.state;
  if (!s.pixel || !workbench.scene()) return;
  const int by = ImGui::GetIO().KeyShift ? 10 : 1;
  glm::ivec2 to(*s.pixel);
  if (pressed_named(ImGuiKey_LeftArrow, true)) to.x -= by;
  if (pressed_named(ImGuiKey_RightArrow, true)) to.x += by;
  if (pressed_named(ImGuiKey_UpArrow, true)) to.y -= by;
  if (pressed_named(ImGuiKey_DownArrow, true)) to.y += by;
  const glm::ivec2 last = glm::ivec2(workbench.scene()->scene().image_size) - 1;
  const glm::uvec2 pixel(glm::clamp(to, glm::ivec2(0), last));
  if (pixel == *s.pixel) return;
  s.pixel = pixel;
  s.step.reset();
  s.node.reset();
}

void move_step(Workbench& workbench, int by) {
  const auto& result = workbench.inspection();
  if (!result || result->inspection.final_size == 0) return;
  const int last = int(result->inspection.final_size);
  const auto now = std::min<std::uint32_t>(workbench.state.step.value_or(last), unsigned(last));
  const int step = std::clamp(int(now) + by, 1, last);
  workbench.state.step = step == last ? std::nullopt : std::optional(std::uint32_t(step));
}

void let_go(ViewState& s) {
  if (s.node) {
    s.node.reset();
  } else {
    s.pixel.reset();
    s.step.reset();
  }
}

/// With a selection, arrows and the like; always, what is shown.
void handle_view_keys(Workbench& workbench) {
  ViewState& s = workbench.state;
  if (pressed_named(ImGuiKey_Tab)) s.display = next(s.display, ImGui::GetIO().KeyShift ? -1 : 1);
  if (pressed_named(ImGuiKey_PageDown)) s.layer = next(s.layer, 1);
  if (pressed_named(ImGuiKey_PageUp)) s.layer = next(s.layer, -1);
  if (pressed('S')) s.split = !s.split;
  if (pressed('L')) {
    s.colours.logarithmic = !s.colours.logarithmic;
    s.colours.automatic_range = true; // the other one may begin below 0
  }
  if (pressed('F')) s.image.fits = true;
  if (pressed('1') && workbench.scene()) {
    const glm::dvec2 middle = 0.5 * glm::dvec2(workbench.scene()->scene().image_size);
    if (s.image.fits) s.image.centre = middle;
    s.image = one_to_one(s.image);
  }
  if (pressed('R')) s.camera.reset();
  if (pressed(',', true)) move_step(workbench, -1);
  if (pressed('.', true)) move_step(workbench, 1);
  if (pressed_named(ImGuiKey_Escape)) let_go(s);
  move_pixel(workbench);
}

} // namespace

std::span<const Shortcut> all_shortcuts() { return shortcuts; }

KeyRequests handle_keys(Workbench& workbench) {
  const ImGuiIO& io = ImGui::GetIO();
  KeyRequests requests;
  if (io.WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return requests;
  requests.help = typed('?');
  requests.flip = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space));
  if (!io.KeyCtrl) {
    handle_view_keys(workbench);
    return requests;
  }
  requests.open = pressed('O');
  requests.save = pressed('S');
  requests.quit = pressed('Q');
  return requests;
}

} // namespace lightcuts::viz
