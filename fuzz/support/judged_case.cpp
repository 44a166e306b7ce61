// SPDX-License-Identifier: MIT
#include <fuzz/support/judged_case.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include <lightcuts/render/files/output_folder.h>
#include <oracle/campaign/hunt.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/properties/each_view.h>
#include <oracle/subjects/library_subject.h>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {

using oracle::Case;
using oracle::Property;
using oracle::Tally;

const oracle::Subject& library() {
  static const std::unique_ptr<oracle::Subject> subject = oracle::library_subject();
  return *subject;
}

void require_held(const Case& on, const Tally& tally) {
  const std::vector<Property> properties = broken(tally);
  if (properties.empty()) return;
  const Property property = properties.front();
  constexpr double seconds = 5; // the fuzzer's limit is larger
  const oracle::Counterexample found =
      shrunk(library(), {property, on, tally[property].first_violation}, seconds);
  const char* folder = std::getenv("LIGHTCUTS_FUZZ_FINDINGS");
  const std::filesystem::path file = std::filesystem::path(folder != nullptr ? folder : ".") /
                                     fmt::format("counterexample-{}.json", info(property).name);
  write_file_atomically(file, oracle::counterexample_json({library().name(), found}));
  finding(fmt::format("{} does not hold: {}\nlightcuts-oracle replay {}", info(property).name,
                      found.message, file.string()));
}

void judge_views(
    const Case& on,
    const std::function<void(const oracle::Judge&, const oracle::PointAnswers&)>& check) {
  Tally tally;
  const oracle::Judge judge(library().parts(), 0, tally);
  const LightSet lights = on.light_set();
  const auto tree = library().build(lights, on.seed);
  const auto topology = judge.tree(tree->claim(), lights);
  if (topology)
    for_each_view(on, *topology, lights, 0, [&](std::size_t, const oracle::PointCase& at) {
      check(judge, oracle::PointAnswers({*tree, library().parts()}, at));
      return false;
    });
  require_held(on, tally);
}

void judge(const Case& on, std::optional<Property> only) {
  Tally tally;
  check_case(library(), on, 0, tally, only);
  require_held(on, tally);
}

} // namespace lightcuts::fuzz
