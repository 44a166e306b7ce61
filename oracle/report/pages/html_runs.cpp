// SPDX-License-Identifier: MIT
#include <oracle/report/pages/html_runs.h>

#include <fmt/format.h>

#include <oracle/report/pages/html_text.h>
#include <oracle/report/pages/report_numbers.h>

namespace lightcuts::oracle {
namespace {

struct Column {
  const char* group; // over the first of the columns that share it
  int group_size;
  const char* name;
  std::string (*cell)(const Run&, const Report&);
  const char* meaning; // HTML
};

std::string unless_reference(const Run& run, const std::string& text) {
  return is_reference(run) ? "-" : text;
}

std::string if_sampled(const Run& run, const std::string& text) {
  return run.optimal_cut_size > 0 ? text : "-";
}

using R = const Run&;
using A = const Report&;

const Column columns[] = {
    {"", 2, "method", [](R r, A) { return r.method; },
     "How pixels are lit: <b>reference</b> sums every light, the others evaluate a cut of the "
     "light tree."},
    {"", 0, "threshold", [](R r, A) { return threshold_text(r); },
     "A cluster is refined until its error bound is at most this share of the pixel’s estimate. It "
     "holds for each cluster; the error of their sum may exceed it."},
    {"speed", 4, "render", [](R r, A) { return three_digits(r.render_seconds) + " s"; },
     "Seconds for the picture, primary rays included: median of the interleaved runs."},
    {"", 0, "build",
     [](R r, A) { return unless_reference(r, three_digits(r.build_seconds) + " s"); },
     "Seconds to build the light tree, once per scene."},
    {"", 0, "speed-up", [](R r, A) { return three_digits(r.speedup_over_reference) + "×"; },
     "Render seconds of the reference / render seconds. The build is not in it."},
    {"", 0, "efficiency",
     [](R r, A) { return r.efficiency > 0 ? three_digits(r.efficiency) : std::string("-"); },
     "<code>1 / (rel. RMSE² · render seconds)</code>. Higher is better: what halves the error or "
     "quarters the time makes it four times as high."},
    {"work per pixel", 4, "cut", [](R r, A) { return number(r.mean_cut_size); },
     "Clusters (reference: lights) summed per pixel, in the mean."},
    {"", 0, "rays", [](R r, A) { return number(r.shadow_rays_per_pixel); },
     "Shadow rays traced per pixel, in the mean."},
    {"", 0, "optimal cut", [](R r, A) { return if_sampled(r, number(r.optimal_cut_size)); },
     "The smallest cut of the same tree whose clusters all truly err by at most the threshold × "
     "the true total: what a clairvoyant would choose. Mean over a sample of pixels."},
    {"", 0, "cut efficiency", [](R r, A) { return if_sampled(r, percent(r.cut_efficiency)); },
     "Optimal cut / actual cut over those pixels. 100 % would be perfect bounds."},
    {"relative error", 4, "mean", [](R r, A) { return percent(r.mean_relative_error); },
     "Mean over the pixels of their relative error, "
     "<code>Σ<sub>c</sub> |v<sub>c</sub> − r<sub>c</sub>| / max(Σ<sub>c</sub> r<sub>c</sub>, "
     "3 · black level)</code>, with v the picture, r the exact one and c the colour channels."},
    {"", 0, "largest", [](R r, A) { return percent(r.max_relative_error); },
     "The relative error of the worst pixel."},
    {"", 0, "certified", [](R r, A) { return percent(r.mean_certified_error); },
     "The error that the bounds of the cut guarantee, summed over clusters and channels and "
     "divided by the same denominator. In each pixel it is at least the true error; here its "
     "mean."},
    {"", 0, "pixels over",
     [](R r, A a) {
       return unless_reference(r, share_of(r.pixels_over_threshold, a.surface_pixels));
     },
     "Share of the pixels whose relative error is above the threshold."},
    {"squared error", 2, "rel. RMSE", [](R r, A) { return percent(r.rel_rmse); },
     "<code>√mean<sub>p,c</sub>((v − r)²) / mean<sub>p,c</sub>(r)</code> over pixels p and "
     "channels c. Bright pixels dominate."},
    {"", 0, "MRSE", [](R r, A) { return r.mrse == 0 ? "0" : fmt::format("{:.1e}", r.mrse); },
     "<code>mean<sub>p,c</sub>((v − r)² / (r + 0.01)²)</code>: relative, so dark pixels count "
     "as much as bright ones."},
    {"ended early", 2, "dark",
     [](R r, A a) { return unless_reference(r, share_of(r.dark_pixels, a.surface_pixels)); },
     "Share of the pixels whose refinement ended because every bound was under the black level."},
    {"", 0, "size limit",
     [](R r, A a) {
       return unless_reference(r, share_of(r.size_limited_pixels, a.surface_pixels));
     },
     "Share of the pixels whose refinement ended at the largest cut size allowed: there the "
     "threshold is not promised."},
};

bool starts_group(const Column& column) { return column.group_size > 0; }

std::string group_row() {
  std::string html = "<tr class=\"groups\">";
  for (const Column& c : columns)
    if (starts_group(c))
      html += fmt::format("<th colspan=\"{}\" scope=\"colgroup\">{}</th>", c.group_size, c.group);
  return html + "</tr>\n";
}

std::string name_row() {
  std::string html = "<tr>";
  for (const Column& c : columns)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", starts_group(c) ? " class=\"first\"" : "",
                        c.name);
  return html + "</tr>\n";
}

std::string run_row(const Run& run, const Report& report) {
  std::string html = is_reference(run) ? "<tr class=\"reference\">" : "<tr>";
  for (const Column& c : columns) {
    const std::string text = c.cell(run, report);
    html += fmt::format("<td{}>{}</td>", starts_group(c) ? " class=\"first\"" : "",
                        text == "-" ? "–" : html_text(text));
  }
  return html + "</tr>\n";
}

} // namespace

std::string html_runs(const Report& report) {
  std::string html = "<div class=\"wide\" tabindex=\"0\"><table>\n<thead>\n" + group_row() +
                     name_row() + "</thead>\n<tbody>\n";
  for (const Run& run : report.runs) html += run_row(run, report);
  return html + "</tbody>\n</table></div>\n";
}

std::string html_legend(const Report& report) {
  std::string html = fmt::format(
      "<p>Errors are over the {} pixels that see a surface. The black level, a radiance under "
      "which light is taken for darkness, is {:.3g}.</p>\n<dl class=\"legend\">\n",
      grouped(report.surface_pixels), report.black_level);
  const char* group = "";
  for (const Column& c : columns) {
    if (starts_group(c)) group = c.group;
    html += fmt::format("<div><dt>{} <span>{}</span></dt><dd>{}</dd></div>\n", c.name, group,
                        c.meaning);
  }
  return html + "</dl>\n";
}

} // namespace lightcuts::oracle
