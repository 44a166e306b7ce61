// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <oracle/properties/properties.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::cli {

/// A line per property with its cases, violations and worst ratio, and what the first violation is;
/// then which parts the subject does not offer, and what all that amounts to.
[[nodiscard]] std::string property_table(const oracle::Tally& tally,
                                         const oracle::Subject& subject);

/// Cases, violations, worst ratio and first violation of each property, as a JSON list.
[[nodiscard]] nlohmann::ordered_json properties_json(const oracle::Tally& tally);

/// all_holds or violated: waste alone is a failure of the library, but of nobody else.
[[nodiscard]] int exit_code_for(const oracle::Tally& tally, const oracle::Subject& subject);

} // namespace lightcuts::cli
