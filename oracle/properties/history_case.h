// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/cases/case.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// A case whose subject has a history: Case::builds, or Case::questions about views but the first.
/// It has lights and a view.
struct HistoryCase {
  const Subject& subject;
  const Case& on;
};

} // namespace lightcuts::oracle
