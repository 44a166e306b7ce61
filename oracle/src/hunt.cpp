// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/hunt.h>

#include <chrono>
#include <utility>

#include <lightcuts/input_error.h>

namespace lightcuts::oracle {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The first property that does not hold, violations before waste.
std::optional<Property> broken(const Tally& tally, bool waste) {
  for (const Severity severity : {Severity::violation, Severity::waste})
    for (std::size_t i = 0; i < property_count; ++i)
      if (info(Property(i)).severity == severity && tally[Property(i)].violations > 0 &&
          (waste || severity == Severity::violation))
        return Property(i);
  return std::nullopt;
}

} // namespace

HuntResult hunt(const Subject& subject, const HuntConfig& config) {
  const auto start = Clock::now();
  HuntResult result;
  while (result.cases < config.cases && !result.found &&
         (config.seconds == 0 || seconds_since(start) < config.seconds)) {
    const std::uint64_t index = result.cases++;
    const Case on = random_case(config.seed, index);
    Tally tally;
    check_case(subject, on, index, tally);
    if (const auto property = broken(tally, config.waste))
      result.found = {*property, on, tally[*property].first_violation, index};
    result.tally.merge(tally);
    if (config.progress) config.progress(double(result.cases) / double(config.cases));
  }
  result.seconds = seconds_since(start);
  return result;
}

std::optional<std::string> failure_of(const Subject& subject, Property property, const Case& on) {
  Tally tally;
  try {
    check_case(subject, on, 0, tally);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (tally[property].violations == 0) return std::nullopt;
  return tally[property].first_violation;
}

Counterexample shrunk(const Subject& subject, const Counterexample& found, double seconds) {
  const auto start = Clock::now();
  Counterexample best = found;
  for (bool simpler_one_fails = true; simpler_one_fails && seconds_since(start) < seconds;) {
    simpler_one_fails = false;
    for (Case& candidate : simpler(best.on)) {
      if (seconds_since(start) >= seconds) break;
      auto failure = failure_of(subject, best.property, candidate);
      if (!failure) continue;
      best.on = std::move(candidate);
      best.message = std::move(*failure);
      simpler_one_fails = true;
      break;
    }
  }
  return best;
}

} // namespace lightcuts::oracle
