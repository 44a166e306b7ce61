// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <viz/model/workbench.h>

#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {

/// As the window does, until nothing more happens; what a frame asks for may be there in the next.
inline void settle(Workbench& bench) {
  int quiet = 0;
  ASSERT_TRUE(comes_true([&] {
    bench.update();
    quiet = bench.busy() ? 0 : quiet + 1;
    return quiet >= 3;
  }));
}

/// With the small scene and always cuts.
struct SmallWorkbench : Workbench {
  SmallWorkbench() {
    state.open = small_request();
    state.shading = always_cuts();
  }
};

} // namespace lightcuts::viz
