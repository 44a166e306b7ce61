// SPDX-License-Identifier: MIT
// A counterexample file: what is read comes out as it went in, and the library is right on every
// case that is valid and small.
#include <fmt/format.h>

#include <oracle/counterexamples/as_test.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/explain/explain.h>

#include <fuzz/support/files.h>
#include <fuzz/support/judged_case.h>
#include <fuzz/support/mutate_json.h>

namespace lightcuts::fuzz {
namespace {

/// Whether judging it takes milliseconds.
bool is_small(const oracle::Case& on) {
  return on.lights.size() <= 16 && on.views.size() <= 3 && on.triangles.size() <= 16 &&
         on.image_size.x * on.image_size.y <= 16 && on.builds <= 4 && on.questions <= 40 &&
         !on.draws;
}

void run_counterexample(Bytes input) {
  const std::string name = "fuzzed.json";
  read_or_refused(name, [&] {
    const oracle::SavedCounterexample saved = oracle::read_counterexample(name, text_of(input));
    const std::string again = oracle::counterexample_json(saved);
    if (const auto copy = oracle::read_counterexample(name, again);
        oracle::counterexample_json(copy) != again)
      finding("is read as another one than was written");
    (void)oracle::as_test(saved);
    if (!is_small(saved.counterexample.on)) return;
    judge(saved.counterexample.on);
    (void)oracle::explain(library(), saved.counterexample);
  });
}

const Registered counterexample({"counterexample", run_counterexample, mutated_json});

} // namespace
} // namespace lightcuts::fuzz
