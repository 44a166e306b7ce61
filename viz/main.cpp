// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/output_folder.h>
#include <oracle/options/program.h>
#include <viz/gl/context/gl_error.h>
#include <viz/options.h>
#include <viz/panels/app/offscreen.h>
#include <viz/panels/app/window.h>

namespace lightcuts::viz {
namespace {

void begin(App& app, const Options& options) {
  app.workbench().state = options.view;
  if (!options.has_colours) app.workbench().state.colours.map = app.settings().colour_map;
  if (options.tab) app.show(*options.tab);
}

/// Complains of what the window would have shown as a message.
void require_scene(Workbench& workbench) {
  for (const Message& message : workbench.messages()) fmt::print(stderr, "{}\n", message.text);
  if (workbench.scene()) return;
  throw InputError(InputFault::missing, workbench.opening()
                                            ? "the scene is not open yet; --wait waits longer"
                                            : "nothing to show");
}

int take_screenshot(const Options& options) {
  const std::filesystem::path file = options.screenshot;
  require_writable(file);
  Offscreen offscreen(options.size.value_or(glm::uvec2(1280, 800)), options.scale.value_or(1), {},
                      options.out);
  begin(offscreen.app(), options);
  const bool complete = offscreen.settle(options.wait);
  Workbench& workbench = offscreen.app().workbench();
  require_scene(workbench);
  workbench.clear_messages();
  if (options.tab) offscreen.app().show(*options.tab);
  for (int i = 0; i < 3; ++i) offscreen.frame();
  write_png(file, offscreen.size(), offscreen.screenshot());
  if (!complete)
    fmt::print(stderr, "{}: not all was there after {:g} s\n", file.string(), options.wait);
  return options::all_holds;
}

int show_window(const Options& options) {
  const std::filesystem::path folder = config_folder();
  std::string problem;
  const AppSettings settings = load_settings(folder, problem);
  run_window(
      options.sized(settings), options.scale, options.out,
      [&](App& app) {
        if (!problem.empty()) app.workbench().say(problem, true);
        begin(app, options);
      },
      [&](const AppSettings& left) { save_settings(left, folder); });
  return options::all_holds;
}

int run(int argc, char** argv) {
  CLI::App command("A window that shows what lightcuts does at a pixel, and why.", "lightcuts-viz");
  Options options;
  add_options(command, options);
  try {
    command.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return command.exit(error) == 0 ? options::all_holds : options::usage;
  }
  return options.screenshot.empty() ? show_window(options) : take_screenshot(options);
}

} // namespace
} // namespace lightcuts::viz

int main(int argc, char** argv) {
  using namespace lightcuts;
  return options::run_program("lightcuts-viz", [&] {
    try {
      return viz::run(argc, argv);
    } catch (const viz::GlError& error) {
      throw InputError(InputFault::unsupported, error.what());
    }
  });
}
