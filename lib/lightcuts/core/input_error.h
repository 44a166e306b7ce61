// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace lightcuts {

/// Why input is refused, whichever element it is.
enum class InputFault : std::uint8_t {
  not_finite,    ///< a NaN or an infinity
  negative,      ///< a number below 0 where the domain has none
  not_unit,      ///< a direction whose length is not 1
  out_of_domain, ///< any other value outside its domain
  inconsistent,  ///< parts that do not go together: an index out of range, lists of unequal length
  missing,       ///< nothing where something is needed: no triangle, no light, no value
  unknown_name,  ///< a name that means nothing here
  unsupported,   ///< a version, a kind of file or a machine that this library cannot handle
  too_large,     ///< more than this library can count, or the memory hold
  unreadable_file, ///< a file that is not there, or cannot be read
  unwritable_file, ///< a file or folder that cannot be written
  malformed_file   ///< a file, or text as of one, that breaks the rules of its format
};
inline constexpr int input_fault_count = 12;
[[nodiscard]] constexpr std::array<const char*, input_fault_count> names_of(InputFault /*any*/) {
  return {"not-finite",   "negative",        "not-unit",        "out-of-domain",
          "inconsistent", "missing",         "unknown-name",    "unsupported",
          "too-large",    "unreadable-file", "unwritable-file", "malformed-file"};
}

/// Why a number is refused where only finite ones of 0 or more are allowed, and not all of them.
[[nodiscard]] inline InputFault fault_of(double value) {
  if (!std::isfinite(value)) return InputFault::not_finite;
  return value < 0 ? InputFault::negative : InputFault::out_of_domain;
}

/// Input that this library refuses: a NaN, a negative intensity, an unreadable file. The message is
/// one line that names the element (and the file, where there is one). Thrown at the door only;
/// nothing behind it throws.
class InputError : public std::runtime_error {
public:
  InputError(InputFault fault, const std::string& message)
      : std::runtime_error(message), fault_(fault) {}

  [[nodiscard]] InputFault fault() const noexcept { return fault_; }

private:
  InputFault fault_;
};

} // namespace lightcuts
