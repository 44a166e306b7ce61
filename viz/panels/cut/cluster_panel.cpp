// SPDX-License-Identifier: MIT
#include <viz/panels/cut/cluster_panel.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui_stdlib.h>
#include <lightcuts/render/files/text.h>

#include <viz/model/layers/value_text.h>

namespace lightcuts::viz {
namespace {

const ImVec4 error_colour{1, 0.45F, 0.4F, 1};
const ImVec4 blocked_colour{1, 0.55F, 0.5F, 1};
constexpr const char* not_known_yet = "...";
constexpr ImGuiTableFlags table_flags =
    ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable | ImGuiTableFlags_Reorderable |
    ImGuiTableFlags_Hideable | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
    ImGuiTableFlags_ScrollY | ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit;

std::string cell_text(const ClusterRow& row, ClusterColumn column) {
  if (column == ClusterColumn::sight) return row.sight ? name_of(*row.sight) : "-";
  const std::optional<double> value = scalar_of(row, column);
  if (value && column <= ClusterColumn::lights) return fmt::format("{:.0f}", *value);
  if (value && column == ClusterColumn::representative) return fmt::format("{:.0f}", *value);
  if (value) return short_text(*value);
  return column == ClusterColumn::representative ? "-" : not_known_yet;
}

/// All of a row, channel by channel.
std::string details(const ClusterRow& row) {
  const auto truth = row.truth ? rgb_text(*row.truth) : std::string(not_known_yet);
  const auto error_text = error(row) ? short_text(*error(row)) : std::string(not_known_yet);
  const char* seen = row.representative == oracle::TreeClaim::unsaid ? "not said"
                     : row.visible                                   ? "seen"
                                                                     : "hidden";
  return fmt::format("node {}, depth {}, {}\nintensity {} W/sr\nrepresentative {} ({})\n"
                     "sight {}\n"
                     "bound    {} radiance\nestimate {}\ntruth    {}\nerror    {}\nshare {}",
                     row.node, row.depth, counted(row.lights, "light"), rgb_text(row.intensity),
                     cell_text(row, ClusterColumn::representative), seen,
                     cell_text(row, ClusterColumn::sight), rgb_text(row.bound),
                     rgb_text(row.estimate), truth, error_text, short_text(row.share));
}

bool is_up_to_date(const ClusterContents& contents, const ClusterPanelState& state) {
  const auto& order = state.order;
  return order && order->filter == state.filter && order->column == state.column &&
         order->descending == state.descending && order->revision == contents.revision &&
         order->of == contents.rows.size();
}

void update_order(const ClusterContents& contents, ClusterPanelState& state) {
  if (is_up_to_date(contents, state)) return;
  FilterReading reading = read_filter(state.filter);
  ClusterOrder& order = state.order.emplace();
  order.filter = state.filter;
  order.error = std::move(reading.error);
  order.column = state.column;
  order.descending = state.descending;
  order.revision = contents.revision;
  order.of = contents.rows.size();
  order.rows = sorted_and_filtered(contents.rows, state.column, state.descending, reading.filter);
}

void draw_filter(const ClusterContents& contents, ClusterPanelState& state) {
  ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x * 0.6F, 80.0F));
  ImGui::InputTextWithHint("##filter", "filter: lights>10 error>=1e-3 hidden", &state.filter);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("Conditions separated by spaces, all of which must hold:\n"
                      "a column, one of < <= = != >= >, and a number; or visible, or hidden;\n"
                      "or sight=seen, hidden, ray or share.");
  update_order(contents, state);
  ImGui::SameLine();
  ImGui::Text("%zu of %zu", state.order->rows.size(), contents.rows.size());
  if (!state.order->error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, error_colour);
    ImGui::TextWrapped("%s", state.order->error.c_str());
    ImGui::PopStyleColor();
  }
}

void set_up_columns(const ClusterPanelState& state) {
  ImGui::TableSetupScrollFreeze(1, 1);
  // Truths come later, and are longer than what stands there until then.
  const float number = ImGui::CalcTextSize("8.888e-88").x;
  const float arrow = ImGui::GetFontSize() * 0.65F + ImGui::GetStyle().FramePadding.x;
  for (int i = 0; i < cluster_column_count; ++i) {
    const auto column = ClusterColumn(i);
    ImGuiTableColumnFlags flags = column == ClusterColumn::node ? ImGuiTableColumnFlags_NoHide : 0;
    if (column == state.column) flags |= ImGuiTableColumnFlags_DefaultSort;
    if (i >= int(ClusterColumn::share) || state.descending)
      flags |= ImGuiTableColumnFlags_PreferSortDescending;
    const bool is_long = column >= ClusterColumn::bound && column <= ClusterColumn::error;
    const char* name = info_of(column).name.data();
    const float width = std::max(number, ImGui::CalcTextSize(name).x + arrow);
    ImGui::TableSetupColumn(name, flags, is_long ? width : 0, ImGuiID(i));
  }
}

void draw_headers() {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int i = 0; i < cluster_column_count; ++i) {
    if (!ImGui::TableSetColumnIndex(i)) continue;
    const ClusterColumnInfo& info = info_of(ClusterColumn(i));
    ImGui::TableHeader(info.name.data());
    if (!ImGui::IsItemHovered()) continue;
    const std::string unit = info.unit.empty() ? "" : fmt::format(" [{}]", info.unit);
    ImGui::SetTooltip("%s%s\n%s", info.name.data(), unit.c_str(), info.help.data());
  }
}

/// By what the headers say; the rows follow at once.
void follow_headers(const ClusterContents& contents, ClusterPanelState& state) {
  const ImGuiTableSortSpecs* sort = ImGui::TableGetSortSpecs();
  if (sort == nullptr || sort->SpecsCount == 0) return;
  state.column = ClusterColumn(sort->Specs[0].ColumnUserID);
  state.descending = sort->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  update_order(contents, state);
}

void scroll_to_selection(const ClusterContents& contents, ClusterPanelState& state) {
  if (contents.selected == state.shown_selection) return;
  state.shown_selection = contents.selected;
  const std::vector<std::uint32_t>& order = state.order->rows;
  const auto found = std::find_if(order.begin(), order.end(), [&](std::uint32_t i) {
    return contents.rows[i].node == contents.selected;
  });
  if (found == order.end()) return;
  const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float middle = ImGui::GetWindowHeight() / 2;
  ImGui::SetScrollY(std::max(height * float(found - order.begin() + 1) - middle, 0.0F));
}

void draw_row(const ClusterRow& row, std::optional<std::uint32_t> selected, ClusterEvents& events) {
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(0);
  if (ImGui::Selectable(std::to_string(row.node).c_str(), row.node == selected,
                        ImGuiSelectableFlags_SpanAllColumns))
    events.clicked = row.node;
  if (ImGui::IsItemHovered()) {
    events.hovered = row.node;
    ImGui::SetTooltip("%s", details(row).c_str());
  }
  for (int i = 1; i < cluster_column_count; ++i) {
    if (!ImGui::TableSetColumnIndex(i)) continue;
    const auto column = ClusterColumn(i);
    const bool blocked = column == ClusterColumn::representative && !row.visible;
    if (blocked) ImGui::PushStyleColor(ImGuiCol_Text, blocked_colour);
    ImGui::TextUnformatted(cell_text(row, column).c_str());
    if (blocked) ImGui::PopStyleColor();
  }
}

ClusterEvents draw_rows(const ClusterContents& contents, ClusterPanelState& state) {
  ClusterEvents events;
  const std::vector<std::uint32_t>& order = state.order->rows;
  ImGuiListClipper clipper;
  clipper.Begin(int(order.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(contents.rows[order[std::size_t(i)]], contents.selected, events);
  // Clicked here, it need not be scrolled to.
  if (events.clicked) state.shown_selection = events.clicked;
  return events;
}

} // namespace

ClusterEvents draw_clusters(const char* id, const ClusterContents& contents,
                            ClusterPanelState& state, ImVec2 size) {
  ImGui::PushID(id);
  const float top = ImGui::GetCursorPosY();
  draw_filter(contents, state);
  if (size.y > 0) size.y = std::max(size.y - (ImGui::GetCursorPosY() - top), 60.0F);
  ClusterEvents events;
  if (ImGui::BeginTable("clusters", cluster_column_count, table_flags, size)) {
    set_up_columns(state);
    draw_headers();
    follow_headers(contents, state);
    scroll_to_selection(contents, state);
    events = draw_rows(contents, state);
    ImGui::EndTable();
  }
  ImGui::PopID();
  return events;
}

} // namespace lightcuts::viz
