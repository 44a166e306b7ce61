// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lightcuts::viz {

/// The graphics driver cannot do what it was asked for. The message is for the user: what was
/// wanted, and what the driver said.
struct GlError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace lightcuts::viz
