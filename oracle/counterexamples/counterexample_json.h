// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <oracle/campaign/hunt.h>

namespace lightcuts::oracle {

inline constexpr const char* counterexample_schema = "lightcuts-oracle/counterexample/1";

/// A counterexample and whose it is.
struct SavedCounterexample {
  /// "lightcuts", "paper", "mutant:NAME", or the absolute path of a plug-in: full_subject_name().
  std::string subject;
  Counterexample counterexample;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("subject", &SavedCounterexample::subject);
    field("counterexample", &SavedCounterexample::counterexample, domain::inlined);
  }
};

/// JSON of schema lightcuts-oracle/counterexample/1. Each float is a hexadecimal string, "0x1.8p+1"
/// for 3, exact; beside it, as KEY_decimal, are decimals for readers. What a light's kind does not
/// use is left out, and so is what is optional and has its default value: see the records' fields.
[[nodiscard]] std::string counterexample_json(const SavedCounterexample& saved);

/// Reads what counterexample_json() writes; decimals beside are ignored, and a number will do for a
/// hexadecimal string. Throws InputError that names `name` and the path in it, as `a.json:
/// /case/lights/3/position/0 is "abc", expected a finite float such as "0x1.8p+1"`, where anything
/// is missing, unknown or out of its domain: a case so read is valid.
[[nodiscard]] SavedCounterexample read_counterexample(const std::string& name,
                                                      const std::string& text);

/// Reads the file as read_counterexample() reads a text.
[[nodiscard]] SavedCounterexample load_counterexample(const std::filesystem::path& file);

} // namespace lightcuts::oracle
