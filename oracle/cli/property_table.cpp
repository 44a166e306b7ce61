// SPDX-License-Identifier: MIT
#include <oracle/cli/property_table.h>

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <oracle/cli/common.h>
#include <oracle/cli/subjects.h>

namespace lightcuts::cli {
namespace {

using oracle::Property;
using oracle::PropertyCount;
using oracle::Severity;

std::string ratio_text(double ratio) {
  if (ratio < 0) return "-";
  if (ratio > 1e6) return "> 10^6";
  if (ratio > 1 && ratio < 1.0001) return fmt::format("1 + {:.1e}", ratio - 1);
  return ratio != 0 && ratio < 1e-4 ? fmt::format("{:.1e}", ratio) : fmt::format("{:.4f}", ratio);
}

std::string summary(const oracle::Tally& tally) {
  if (tally.violations() > 0) return fmt::format("{} violations.\n", tally.violations());
  if (tally.wasteful() > 0)
    return fmt::format("Nothing is wrong; {} times a right result costs more than it has to.\n",
                       tally.wasteful());
  return "All properties hold.\n";
}

} // namespace

std::string property_table(const oracle::Tally& tally, const oracle::Subject& subject) {
  std::string text =
      fmt::format("{:<31}{:>12}{:>12}{:>13}\n", "property", "cases", "violations", "worst ratio");
  for (const Property p : oracle::all_properties) {
    const PropertyCount& count = tally[p];
    text += fmt::format("{:<31}{:>12}{:>12}{:>13}\n", info(p).name, count.cases, count.violations,
                        ratio_text(count.worst_ratio));
    if (count.violations > 0)
      text += fmt::format("  first{}: {}\n", count.severity == Severity::waste ? ", a waste" : "",
                          count.first_violation);
  }
  const std::vector<std::string> absent = oracle::names_without(subject.parts());
  if (!absent.empty())
    text += fmt::format("\nnot judged: {} ({} does not offer them)\n", fmt::join(absent, ", "),
                        subject.name());
  return text + "\n" + summary(tally);
}

nlohmann::ordered_json properties_json(const oracle::Tally& tally) {
  auto list = nlohmann::ordered_json::array();
  for (const Property p : oracle::all_properties) {
    const PropertyCount& count = tally[p];
    nlohmann::ordered_json entry{
        {"name", info(p).name}, {"cases", count.cases}, {"violations", count.violations}};
    entry["worst_ratio"] = nullptr; // where the property is a matter of yes or no
    if (count.worst_ratio >= 0) entry["worst_ratio"] = count.worst_ratio;
    if (count.violations > 0) entry["first_violation"] = count.first_violation;
    list.push_back(entry);
  }
  return list;
}

int exit_code_for(const oracle::Tally& tally, const oracle::Subject& subject) {
  if (tally.violations() > 0) return violated;
  return tally.wasteful() > 0 && oracle::is_library(subject) ? violated : all_holds;
}

} // namespace lightcuts::cli
