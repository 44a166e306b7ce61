// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace lightcuts {

/// For tests that RC_GTEST_PROP cannot declare: one for each type, say.
template <class Check>
void check_property(const char* description, const Check& check) {
  EXPECT_TRUE(rc::check(description, check)) << description;
}

} // namespace lightcuts
