// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lightcuts {

/// Input that this library refuses: a NaN, a negative intensity, an unreadable file. The message is
/// one line that names the element (and the file, where there is one). Thrown at the door only;
/// nothing behind it throws.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace lightcuts
