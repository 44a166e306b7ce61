// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/render/images/image_codec.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/progress_line.h>
#include <oracle/options/scene_options.h>
#include <oracle/options/values.h>
#include <oracle/report/measure.h>
#include <oracle/report/pages/report_csv.h>
#include <oracle/report/pages/report_html.h>
#include <oracle/report/pages/report_json.h>
#include <oracle/report/pages/report_table.h>
#include <oracle/report/plots/pictures.h>

namespace lightcuts::cli {
namespace {

struct ReportOptions : CommonOptions {
  std::vector<std::string> methods{"reference", "lightcuts"};
  std::vector<std::string> thresholds{"auto"};
  int repeats = oracle::MeasureConfig{}.repeats;
};

/// In order of asking; auto stands for half the scene's own threshold, that, twice and four times
/// it.
std::vector<float> thresholds_of(const ReportOptions& options, const SceneView& view) {
  std::vector<float> thresholds;
  for (const std::string& text : options.thresholds) {
    if (text != "auto") {
      thresholds.push_back(*options::parse_threshold(text));
      continue;
    }
    for (const float factor : {0.5F, 1.0F, 2.0F, 4.0F})
      thresholds.push_back(factor * default_threshold(view));
  }
  return thresholds;
}

oracle::MeasureConfig config_of(const ReportOptions& options, const SceneView& view) {
  oracle::MeasureConfig config;
  config.seed = options.seed;
  config.builder = build_config_for(options).builder;
  config.max_cut = options.max_cut;
  config.threads = options.threads;
  config.repeats = options.repeats;
  config.methods.clear();
  for (const std::string& name : options.methods) config.methods.push_back(*method_named(name));
  config.thresholds = thresholds_of(options, view);
  return config;
}

int run(const ReportOptions& options) {
  const Scene scene = open_lit_scene_for(options);
  const std::filesystem::path out = output_folder_for(options);
  OutputFolder folder(out);
  (void)image_codec(); // refused before the long job where it cannot be loaded
  const SceneView view(scene);
  oracle::MeasureConfig config = config_of(options, view);
  oracle::Measurement m;
  {
    ProgressLine line("report " + options.open.spec);
    config.progress = line.progress();
    m = measure(view, config);
  }
  m.report.pictures = oracle::write_pictures(
      {m.shown, &m.reference, m.report.black_level, scene.name, options.seed, m.shown_threshold},
      folder);
  m.report.scene = options.open.spec;
  const std::string json = report_json(m.report);
  write_file_atomically(folder.stage("report.json"), json);
  write_file_atomically(folder.stage("report.csv"), report_csv(m.report));
  const std::filesystem::path html = folder.stage("report.html");
  write_file_atomically(html, report_html(m.report, html.parent_path()));
  folder.commit();
  print_results(options, report_table(m.report) + fmt::format("written to {}\n", out.string()),
                json);
  return all_holds;
}

} // namespace

void add_report_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<ReportOptions>();
  options->open.spec = "desk";
  CLI::App* command = app.add_subcommand(
      "report", "Measure error against run time: report.html, .json, .csv, EXR and PNG.");
  add_common_options(*command, *options);
  options::add_builder_option(*command, options->open.builder);
  add_out_option(*command, *options);
  command->add_option("--methods", options->methods, "rows of the table, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(method_names()))
      ->capture_default_str();
  command
      ->add_option("--thresholds,--threshold", options->thresholds,
                   "of the methods that have one, separated by commas; auto: half, once, twice "
                   "and four times that of render --threshold auto")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(options::check_threshold)
      ->capture_default_str();
  command->add_option("--repeats", options->repeats, "runs of each row, in turn; the median counts")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
