// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <oracle/cases/case.h>

namespace lightcuts::oracle {

/// A case that is hard in a way that has a name.
struct NamedCase {
  const char* name;
  const char* why; ///< it is hard: one sentence
  Case (*make)();
  bool is_large = false; ///< takes seconds
};

/// All of them, by subject. Each has a few neighbouring views, which are bounded as one block, too,
/// and, where lights are few and the point is within reach of a camera, a picture.
[[nodiscard]] std::span<const NamedCase> catalogue();
[[nodiscard]] const NamedCase* named_case(std::string_view name);

/// The case with what each entry of the catalogue has.
[[nodiscard]] Case complete(const NamedCase& of);

} // namespace lightcuts::oracle
