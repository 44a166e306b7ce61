// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/cases/case.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// A case whose subject has a history: Case::builds or Case::questions. It has lights, and, for
/// questions, two views.
struct HistoryCase {
  const Subject& subject;
  const Case& on;
};

} // namespace lightcuts::oracle
