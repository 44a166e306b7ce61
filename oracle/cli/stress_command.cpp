// SPDX-License-Identifier: MIT
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "commands.h"
#include "common.h"
#include <lightcuts/oracle/hunt.h>
#include <lightcuts/oracle/mutants.h>

namespace lightcuts::cli {
namespace {
int run(const CommonOptions& options, const std::string& name) {
  std::unique_ptr<oracle::Subject> s = subject_for(options);
  if (!name.empty()) s = oracle::mutant_named(name)->subject();
  oracle::HuntConfig c;
  c.seed = options.seed;
  c.cases = std::stoull(options.cases);
  c.waste = !options.subject; // it is for a foreign tree to choose
  auto r = oracle::hunt(*s, c);
  fmt::print("{} cases {:.2f} s\n", r.cases, r.seconds);
  for (std::size_t i = 0; i < oracle::property_count; ++i)
    fmt::print("{:<32} {:>10} {:>6} {}\n", info(oracle::Property(i)).name,
               r.tally[oracle::Property(i)].cases, r.tally[oracle::Property(i)].violations,
               r.tally[oracle::Property(i)].worst_ratio);
  fmt::print("{}", not_judged(*s));
  if (r.found) {
    fmt::print("{} case {}: {}\n", info(r.found->property).name, r.found->index, r.found->message);
    auto m = shrunk(*s, *r.found);
    std::ostringstream o;
    o << gen::Scene{m.on.lights, m.on.views[0].view, m.on.min_distance};
    fmt::print("{}\n", o.str());
    fmt::print("lights {} views {} triangles {} : {}\n", m.on.lights.size(), m.on.views.size(),
               m.on.triangles.size(), m.message);
  }
  return r.found ? violated : all_holds;
}
} // namespace
void add_stress_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CommonOptions>();
  auto name = std::make_shared<std::string>();
  options->cases = "10000";
  CLI::App* command = app.add_subcommand("stress", "Check every property on random cases.");
  add_common_options(*command, *options);
  add_cases_option(*command, *options);
  add_subject_option(*command, *options);
  command->add_option("--mutant", *name);
  command->callback(
      [options, name, &chosen] { chosen = [options, name] { return run(*options, *name); }; });
}
} // namespace lightcuts::cli
