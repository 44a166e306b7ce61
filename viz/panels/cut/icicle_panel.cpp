// SPDX-License-Identifier: MIT
#include <viz/panels/cut/icicle_panel.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui_internal.h> // SetItemUsingMouseWheel()
#include <lightcuts/render/files/text.h>

#include <viz/model/cut/cut_overlay.h>
#include <viz/model/layers/value_text.h>

namespace lightcuts::viz {
namespace {

constexpr ImU32 ground = IM_COL32(22, 24, 28, 255), dim = IM_COL32(70, 72, 78, 255);
constexpr ImU32 hatching = IM_COL32(120, 122, 128, 255), dark_text = IM_COL32(10, 10, 10, 255);
constexpr ImU32 outline = IM_COL32(255, 255, 255, 255), light_text = IM_COL32(235, 235, 235, 255);
constexpr float zoom_per_notch = 1.25F;

ImU32 packed(const Rgba8& c) { return IM_COL32(c.r, c.g, c.b, c.a); }

Rgba8 colour_of(IcicleBlockKind kind) {
  switch (kind) {
  case IcicleBlockKind::above_cut:
    return {74, 96, 128, 255};
  case IcicleBlockKind::cut:
    return {240, 170, 60, 255};
  case IcicleBlockKind::below_cut:
    return {58, 56, 62, 255};
  case IcicleBlockKind::merged:
    return {70, 72, 78, 255};
  }
  return unknown_colour;
}

struct Canvas {
  ImDrawList* draw;
  ImVec2 origin;
  float row_height;

  [[nodiscard]] ImVec2 corner(float x, std::uint32_t row) const {
    return {origin.x + x, origin.y + float(row) * row_height};
  }
};

void swatch(ImU32 colour, const char* name) {
  ImGui::SameLine(0, ImGui::GetFontSize());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.15F * size},
                                            {at.x + 0.7F * size, at.y + 0.85F * size}, colour);
  ImGui::Dummy({0.7F * size, size});
  ImGui::SameLine(0, 4);
  ImGui::TextUnformatted(name);
}

void draw_legend(const IcicleContents& contents) {
  const oracle::Topology& tree = contents.tree;
  std::string text =
      fmt::format("{} in {}", counted(tree.size() > 0 ? tree.light_count(0) : 0, "light"),
                  counted(contents.icicle.depth(), "level"));
  if (contents.cut_size > 0) text += "; cut: " + counted(contents.cut_size, "cluster");
  ImGui::TextUnformatted(text.c_str());
  if (contents.cut_size > 0) {
    swatch(packed(colour_of(IcicleBlockKind::above_cut)), "above");
    swatch(packed(colour_of(IcicleBlockKind::cut)), "cut");
    swatch(packed(colour_of(IcicleBlockKind::below_cut)), "below");
  }
  swatch(hatching, "narrower than a pixel");
}

/// Slanted lines, 5 pixels apart.
void hatch(const Canvas& c, ImVec2 lo, ImVec2 hi) {
  if (hi.x - lo.x < 3) return;
  const float height = hi.y - lo.y;
  c.draw->PushClipRect(lo, hi, true);
  const float first = lo.x - height + 5 - std::fmod(lo.x, 5.0F);
  const int count = int(std::ceil((hi.x - first) / 5));
  for (int i = 0; i < count; ++i) {
    const float x = first + 5 * float(i);
    c.draw->AddLine({x, hi.y}, {x + height, lo.y}, hatching);
  }
  c.draw->PopClipRect();
}

void draw_label(const Canvas& c, const IcicleBlock& block, ImVec2 lo, ImVec2 hi, const Rgba8& on) {
  if (hi.x - lo.x < 40) return;
  const std::string text = fmt::format("{}", block.lights);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  if (size.x + 4 > hi.x - lo.x || size.y > hi.y - lo.y) return;
  const bool bright = 2 * on.r + 5 * on.g + on.b > 8 * 110;
  c.draw->AddText({(lo.x + hi.x - size.x) / 2, (lo.y + hi.y - size.y) / 2},
                  bright ? dark_text : light_text, text.c_str());
}

void draw_merged(const Canvas& c, const IcicleBlock& block, ImVec2 lo, ImVec2 hi) {
  c.draw->AddRectFilled(lo, hi, dim);
  hatch(c, lo, hi);
  if (block.cut_nodes > 0)
    c.draw->AddRectFilled({lo.x, hi.y - 3}, hi, packed(colour_of(IcicleBlockKind::cut)));
}

void draw_block(const Canvas& c, const IcicleContents& contents, const IcicleBlock& block) {
  const ImVec2 lo = c.corner(block.x0, block.row);
  ImVec2 hi = c.corner(block.x1, block.row + 1);
  hi.y -= 1;
  if (block.kind == IcicleBlockKind::merged) return draw_merged(c, block, lo, hi);
  if (hi.x - lo.x >= 4) hi.x -= 1; // between neighbours
  const std::optional<Rgba8> given =
      contents.colour ? contents.colour(block.node) : std::optional<Rgba8>();
  const Rgba8 colour = given.value_or(colour_of(block.kind));
  c.draw->AddRectFilled(lo, hi, packed(colour));
  // A colour of its own hides what is the cut.
  if (given && block.kind == IcicleBlockKind::cut && hi.x - lo.x >= 3)
    c.draw->AddRect(lo, hi, packed(colour_of(IcicleBlockKind::cut)));
  draw_label(c, block, lo, hi, colour);
}

/// A frame around a node, wide enough to be seen however narrow the node is.
void draw_frame(const Canvas& c, const Icicle& icicle, const IcicleView& view, std::uint32_t node,
                ImU32 colour) {
  const std::uint32_t depth = icicle.depth_of(node);
  const glm::dvec2 extent = icicle.extent(view, node);
  if (depth < view.first_row || depth - view.first_row >= view.rows) return;
  if (extent.y < 0 || extent.x > view.width) return;
  const auto x0 = float(std::clamp(extent.x, -4.0, double(view.width)));
  const auto x1 = float(std::clamp(extent.y, double(x0) + 3, double(view.width) + 4));
  const ImVec2 lo = c.corner(x0, depth - view.first_row);
  const ImVec2 hi = c.corner(x1, depth - view.first_row + 1);
  c.draw->AddRect(lo, {hi.x, hi.y - 1}, colour, 0, 0, 2);
}

void draw_blocks(const Canvas& c, const IcicleContents& contents, const IcicleView& view,
                 std::optional<std::uint32_t> hovered) {
  const ImVec2 end{c.origin.x + view.width, c.origin.y + float(view.rows) * view.row_height};
  c.draw->PushClipRect(c.origin, end, true);
  c.draw->AddRectFilled(c.origin, end, ground);
  for (const IcicleBlock& block : contents.icicle.blocks(view, contents.cut))
    draw_block(c, contents, block);
  const std::uint32_t size = contents.icicle.depth() > 0 ? contents.tree.size() : 0;
  for (const std::optional<std::uint32_t>& node : {contents.hovered, hovered})
    if (node && *node < size) draw_frame(c, contents.icicle, view, *node, outline);
  if (contents.selected && *contents.selected < size)
    draw_frame(c, contents.icicle, view, *contents.selected, packed(selected_colour));
  c.draw->PopClipRect();
}

void draw_tooltip(const IcicleContents& contents, std::uint32_t node) {
  const oracle::Topology& tree = contents.tree;
  std::string text = fmt::format("node {}, depth {}\n{}", node, contents.icicle.depth_of(node),
                                 counted(tree.light_count(node), "light"));
  if (tree.intensity(node))
    text += fmt::format("\nintensity {} W/sr", rgb_text(*tree.intensity(node)));
  if (contents.row)
    if (const std::optional<ClusterRow> row = contents.row(node))
      text += fmt::format("\nbound {} radiance\nestimate {}", rgb_text(row->bound),
                          rgb_text(row->estimate));
  ImGui::SetTooltip("%s", text.c_str());
}

void drag(const Icicle& icicle, IciclePanelState& state, ImVec2 by) {
  state.dragged += by.y;
  const float rows = std::trunc(state.dragged / state.view.row_height);
  state.dragged -= rows * state.view.row_height;
  state.view = icicle.panned(state.view, by.x, int(rows));
}

/// The last item: hovered, dragged and clicked.
void handle_mouse(const Icicle& icicle, IciclePanelState& state, ImVec2 origin) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
    drag(icicle, state, io.MouseDelta);
  if (ImGui::IsItemActivated()) state.dragged = 0;
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetItemUsingMouseWheel();
  if (io.MouseWheel != 0 && io.KeyShift)
    state.view = icicle.panned(state.view, 0, int(std::copysign(3, io.MouseWheel)));
  else if (io.MouseWheel != 0)
    state.view = icicle.zoomed(state.view, io.MousePos.x - origin.x,
                               std::pow(zoom_per_notch, io.MouseWheel));
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) state.view = icicle.whole(state.view);
}

/// Whether a mouse that was pressed has not moved since: no drag.
bool is_click() {
  const ImGuiIO& io = ImGui::GetIO();
  const float most = io.MouseDragThreshold;
  return io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < most * most;
}

bool is_in_sight(const Icicle& icicle, const IcicleView& view, std::uint32_t node) {
  const glm::dvec2 extent = icicle.extent(view, node);
  const std::uint32_t depth = icicle.depth_of(node);
  return extent.y - extent.x >= 2 && extent.x < view.width && extent.y > 0 &&
         depth >= view.first_row && depth - view.first_row < view.rows;
}

/// Of a selection that was made elsewhere.
void follow_selection(const IcicleContents& contents, IciclePanelState& state) {
  if (contents.selected == state.shown_selection) return;
  state.shown_selection = contents.selected;
  if (!contents.selected || contents.icicle.depth() == 0) return;
  if (*contents.selected >= contents.tree.size()) return;
  if (!is_in_sight(contents.icicle, state.view, *contents.selected))
    state.view = contents.icicle.showing(state.view, *contents.selected);
}

/// Takes the room there is.
void fit(const Icicle& icicle, IciclePanelState& state, ImVec2 size) {
  state.view.width = size.x;
  state.view.rows = std::uint32_t(std::max(size.y / state.view.row_height, 1.0F));
  state.view = icicle.panned(state.view, 0, 0); // within a tree that may be another
}

} // namespace

IcicleEvents draw_icicle(const char* id, const IcicleContents& contents, IciclePanelState& state,
                         ImVec2 size) {
  const float top = ImGui::GetCursorPosY();
  draw_legend(contents);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  size.x = std::max(size.x > 0 ? size.x : room.x, 40.0F);
  size.y = std::max(size.y > 0 ? size.y - (ImGui::GetCursorPosY() - top) : room.y,
                    state.view.row_height);
  fit(contents.icicle, state, size);
  follow_selection(contents, state);

  const ImVec2 origin = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
  const bool released = ImGui::InvisibleButton(id, size);
  handle_mouse(contents.icicle, state, origin);
  IcicleEvents events;
  if (ImGui::IsItemHovered())
    events.hovered = contents.icicle.node_at(state.view, {mouse.x - origin.x, mouse.y - origin.y});
  if (released && is_click()) events.clicked = events.hovered;
  if (events.clicked) state.shown_selection = events.clicked; // it is in sight
  draw_blocks({ImGui::GetWindowDrawList(), origin, state.view.row_height}, contents, state.view,
              events.hovered);
  if (events.hovered && !ImGui::IsItemActive()) draw_tooltip(contents, *events.hovered);
  return events;
}

} // namespace lightcuts::viz
