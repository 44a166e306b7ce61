// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_html.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <oracle/report/plots/base64.h>
#include <oracle/report/plots/inline_svg.h>
#include <oracle/report/plots/plots.h>

#include <oracle/report/pages/html_runs.h>
#include <oracle/report/pages/html_style.h>
#include <oracle/report/pages/html_text.h>
#include <oracle/report/pages/report_numbers.h>

namespace lightcuts::oracle {
namespace {

namespace fs = std::filesystem;

std::string fact(const char* name, const std::string& value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
}

std::string facts(const Report& report) {
  return "<dl class=\"facts\">\n" + fact("lights", grouped(report.lights)) +
         fact("triangles", grouped(report.triangles)) +
         fact("picture", fmt::format("{} × {}", report.size.x, report.size.y)) +
         fact("pixels that see a surface", grouped(report.surface_pixels)) +
         fact("threads", std::to_string(report.threads)) +
         fact("runs per row", std::to_string(report.repeats)) +
         fact("builder of the tree", report.builder) + fact("seed", std::to_string(report.seed)) +
         "</dl>\n";
}

constexpr double small_error = 0.01;

bool is_good(const Run& run) {
  return !is_reference(run) && run.mean_relative_error <= small_error;
}

// A number that no line break parts from its unit.
std::string unbroken(std::string text) {
  for (std::size_t i = 0; (i = text.find(' ', i)) != std::string::npos;)
    text.replace(i, 1, "&nbsp;");
  return text;
}

// One sentence: the fastest row whose error hardly anyone would see.
std::string lead(const Report& report) {
  const Run* best = nullptr;
  for (const Run& run : report.runs)
    if (is_good(run) && (!best || run.render_seconds < best->render_seconds)) best = &run;
  if (!best) return "";
  return fmt::format(
      "<p class=\"lead\">Fastest with a mean error of at most {:g}&nbsp;%: <b>{}</b> "
      "at a threshold of {}. It takes {}&nbsp;s, {}&nbsp;× as fast as summing every "
      "light, and errs by {} in the mean and by {} in the worst pixel.</p>\n",
      100 * small_error, html_text(best->method), unbroken(threshold_text(*best)),
      three_digits(best->render_seconds), three_digits(best->speedup_over_reference),
      unbroken(percent(best->mean_relative_error)), unbroken(percent(best->max_relative_error)));
}

std::string list(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = fmt::format("<section><h2>{}</h2>\n<ul>\n", title);
  for (const std::string& line : lines) html += "<li>" + html_text(line) + "</li>\n";
  return html + "</ul></section>\n";
}

std::string missing(const std::string& why) {
  return "<p class=\"missing\">" + html_text(why) + "</p>";
}

std::string figure(const std::string& content, const std::string& caption) {
  return "<figure>" + content + "<figcaption>" + html_text(caption) + "</figcaption></figure>\n";
}

std::string plot(const Report& report, std::string (*draw)(const Report&), const char* prefix,
                 const char* caption) {
  try {
    return figure(inline_svg(draw(report), prefix), caption);
  } catch (const std::runtime_error& error) {
    return figure(missing(std::string("No plot here: ") + error.what()), caption);
  }
}

std::string plots(const Report& report) {
  std::string html = "<h2>Plots</h2>\n<div class=\"plots\">\n";
  html +=
      plot(report, error_against_time_plot, "time-",
           "Error against run time, a point per threshold. Further to the lower left is better.");
  html += plot(report, error_against_threshold_plot, "threshold-",
               "Error against threshold. The threshold holds for each cluster, not for their sum: "
               "points may lie above the dashed line. The certified error is above the true one.");
  if (!report.cut_sizes.empty())
    html += plot(report, cut_size_histogram, "cuts-",
                 "How large the cuts are, over the pixels of the pictures that see a surface.");
  return html + "</div>\n";
}

std::string picture(const fs::path& file, const std::string& caption) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty())
    return figure(missing("No picture here: cannot read " + file.filename().string()), caption);
  return figure(fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", html_text(caption),
                            base64(bytes)),
                caption);
}

std::string pictures(const Report& report, const fs::path& folder) {
  if (report.pictures.empty()) return "";
  std::string html = "<h2>Pictures</h2>\n<div class=\"pictures\">\n";
  for (const auto& [caption, name] : report.pictures) html += picture(folder / name, caption);
  return html + "</div>\n";
}

std::string head(const Report& report) {
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<title>{} – lightcuts report</title>\n<style>{}</style>\n</head>\n",
                     html_text(report.scene), html_style);
}

} // namespace

std::string report_html(const Report& report, const fs::path& folder_of_pictures) {
  return head(report) +
         "<body>\n<header><p class=\"over\">Lightcuts: error against run time</p>\n<h1>" +
         html_text(report.scene) + "</h1>\n" + facts(report) + lead(report) + "</header>\n" +
         "<h2>Runs</h2>\n" + html_runs(report) + plots(report) +
         pictures(report, folder_of_pictures) + "<div class=\"columns\">\n" +
         list("What the scene needs", report.needs) + list("What was left out", report.left_out) +
         "</div>\n<h2>What the columns mean</h2>\n" + html_legend(report) + "</body>\n</html>\n";
}

} // namespace lightcuts::oracle
