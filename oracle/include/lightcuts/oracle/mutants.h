// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include <lightcuts/oracle/subject.h>

namespace lightcuts::oracle {

/// A deliberately broken variant of the library, as found in public code.
struct Mutant {
  const char* name;
  const char* what_is_wrong;
  std::unique_ptr<Subject> (*make)(const LightTree&); ///< the tree must outlive the subject
};

/// All mutants; the oracle has to convict each.
[[nodiscard]] std::span<const Mutant> mutants();

/// The library itself, as a subject.
[[nodiscard]] std::unique_ptr<Subject> library_subject(const LightTree& tree);

/// Method::paper, as a subject.
[[nodiscard]] std::unique_ptr<Subject> paper_subject(const LightTree& tree);

} // namespace lightcuts::oracle
