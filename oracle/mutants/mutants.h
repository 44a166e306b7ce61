// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// A deliberately broken variant of the library, as found in public code.
struct Mutant {
  const char* name;
  const char* what_is_wrong;
  std::unique_ptr<Subject> (*make)(const char* name);

  [[nodiscard]] std::unique_ptr<Subject> subject() const { return make(name); }
};

/// All mutants; the oracle has to convict each.
[[nodiscard]] std::span<const Mutant> mutants();
[[nodiscard]] const Mutant* mutant_named(std::string_view name);

} // namespace lightcuts::oracle
