// SPDX-License-Identifier: MIT
// What Ctrl+S saves of the window, and --state opens: what is read comes out as it went in.
#include <viz/model/state/view_state.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_json.h>

namespace lightcuts::fuzz {
namespace {

void run_view_state(Bytes input) {
  const std::string name = "fuzzed.json";
  read_or_refused(name, [&] {
    const viz::ViewState state = viz::read_view_state(name, text_of(input));
    if (viz::read_view_state(name, viz::view_state_json(state)) != state)
      finding("is read as another one than was written");
  });
}

const Registered view_state({"view_state", run_view_state, mutated_json});

} // namespace
} // namespace lightcuts::fuzz
