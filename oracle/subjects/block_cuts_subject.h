// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// The library's cuts that neighbours share, by name "block-cuts": a point is judged as one of a
/// block, its neighbours being made up around it, with other reflectances, and each with some
/// lights hidden that the point sees, or the other way round.
[[nodiscard]] std::unique_ptr<Subject> block_cuts_subject();

} // namespace lightcuts::oracle
