// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {

/// Expects that `action` throws an InputError of one line that contains `part`.
template <class Action>
void expect_refusal(const std::string& part, const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(part), std::string::npos)
        << "message: " << message << "\nexpected in it: " << part;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
    return;
  }
  ADD_FAILURE() << "not refused; expected: " << part;
}

/// Expects that `action` throws an InputError for that reason.
template <class Action>
void expect_fault(InputFault fault, const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    EXPECT_STREQ(name_of(error.fault()), name_of(fault)) << error.what();
    return;
  }
  ADD_FAILURE() << "not refused; expected: " << name_of(fault);
}

} // namespace lightcuts
