// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <oracle/report/report.h>

// Numbers as people read them: at most seven characters ("inf" and "nan" included) for counts under
// 1e7 and anything else between 1e-97 and 1e97; not grouped().
namespace lightcuts::oracle {

std::string percent(double share);                            ///< 0.0074: "0.74 %"
std::string share_of(std::uint64_t count, std::uint64_t all); ///< in percent; "-" of none
std::string threshold_text(const Run& run);                   ///< "2 %"; "-" for the reference
std::string number(double value);                             ///< 155.3, 20000
std::string three_digits(double value);                       ///< 0.0123, 1.23, 12.3
std::string grouped(std::uint64_t value);                     ///< "1 000 000"

/// The run that sums all lights: what the others are compared with.
bool is_reference(const Run& run);

} // namespace lightcuts::oracle
