// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_table.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <oracle/report/pages/report_numbers.h>

namespace lightcuts::oracle {
namespace {

constexpr std::size_t column_count = 12;
constexpr std::size_t widest_line = 100;
constexpr std::size_t narrowest_method = 6;
using TableRow = std::array<std::string, column_count>;

const std::array<TableRow, 2> header = {TableRow{"", "thresh-", "mean", "rays", "mean", "max",
                                                 "certi-", "pixels", "render", "speed", //
                                                 "optimal", "cut"},
                                        TableRow{"method", "old", "cut", "/pixel", "error", "error",
                                                 "fied", "over", "seconds", "-up", //
                                                 "cut", "effic."}};

bool starts_code_point(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_code_point));
}

// Without what would break a line or steer the terminal.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
  return text;
}

std::string shortened(std::string text, std::size_t width) {
  if (width_of(text) <= width) return text;
  while (width_of(text) + 1 > width) {
    while (!starts_code_point(text.back())) text.pop_back();
    text.pop_back();
  }
  return text + "~";
}

TableRow row_of(const Report& report, const Run& run) {
  const bool exact = is_reference(run);
  const bool sampled = run.optimal_cut_size > 0;
  return {printable(run.method),
          threshold_text(run),
          number(run.mean_cut_size),
          number(run.shadow_rays_per_pixel),
          percent(run.mean_relative_error),
          percent(run.max_relative_error),
          percent(run.mean_certified_error),
          exact ? "-" : share_of(run.pixels_over_threshold, report.surface_pixels),
          three_digits(run.render_seconds),
          three_digits(run.speedup_over_reference) + "x",
          sampled ? number(run.optimal_cut_size) : "-",
          sampled ? percent(run.cut_efficiency) : "-"};
}

std::vector<TableRow> rows_of(const Report& report) {
  std::vector<TableRow> rows(header.begin(), header.end());
  for (const Run& run : report.runs) rows.push_back(row_of(report, run));
  return rows;
}

std::array<std::size_t, column_count> widths_of(const std::vector<TableRow>& rows) {
  std::array<std::size_t, column_count> widths{};
  for (const TableRow& row : rows)
    for (std::size_t c = 0; c < column_count; ++c)
      widths[c] = std::max(widths[c], width_of(row[c]));
  return widths;
}

std::string aligned(const std::vector<TableRow>& rows) {
  auto widths = widths_of(rows);
  std::size_t numbers = 0;
  for (std::size_t c = 1; c < column_count; ++c) numbers += widths[c];
  const std::size_t gaps = column_count - 1;
  const std::size_t gap = widths[0] + numbers + 2 * gaps <= widest_line ? 2 : 1;
  const std::size_t taken = std::min(numbers + gap * gaps, widest_line - narrowest_method);
  widths[0] = std::min(widths[0], widest_line - taken);
  std::string text;
  for (const TableRow& row : rows) {
    text += fmt::format("{:<{}}", shortened(row[0], widths[0]), widths[0]);
    for (std::size_t c = 1; c < column_count; ++c)
      text += fmt::format("{:>{}}", row[c], widths[c] + gap);
    text += "\n";
  }
  return text;
}

// Broken at spaces, and in words that are wider than a line.
std::string wrapped(std::string_view text, std::string_view indent) {
  std::string result;
  std::string line;
  const auto flush = [&] {
    if (!line.empty()) result += line + "\n";
    line = indent;
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = std::min(text.find(' ', i), text.size());
    const std::size_t room = widest_line - indent.size();
    if (width_of(text.substr(i, end - i)) > room) end = i + room;
    while (end < text.size() && !starts_code_point(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    const bool first = line.empty() || line == indent;
    if (!first && width_of(line) + 1 + width_of(word) > widest_line) flush();
    if (!line.empty() && line != indent) line += " ";
    line += word;
    i = end < text.size() && text[end] == ' ' ? end + 1 : end;
  }
  flush();
  return result;
}

std::string facts_of(const Report& report) {
  return fmt::format("{}: {} lights, {} triangles, {} x {} pixels ({} see a surface), "
                     "{} {}, median of {} {}, {} builder, seed {}",
                     printable(report.scene), grouped(report.lights), grouped(report.triangles),
                     report.size.x, report.size.y, grouped(report.surface_pixels), report.threads,
                     report.threads == 1 ? "thread" : "threads", report.repeats,
                     report.repeats == 1 ? "run" : "runs", report.builder, report.seed);
}

} // namespace

std::string report_table(const Report& report) {
  std::string text = wrapped(facts_of(report), "  ") + "\n" + aligned(rows_of(report));
  if (!report.left_out.empty()) text += "\nleft out:\n";
  for (const std::string& line : report.left_out) text += wrapped("- " + printable(line), "  ");
  return text;
}

} // namespace lightcuts::oracle
