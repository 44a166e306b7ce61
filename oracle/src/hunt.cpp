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
    const std::vector<Property> list = broken(tally);
    if (!list.empty() && (config.waste || info(list.front()).severity == Severity::violation))
      result.found = {list.front(), on, tally[list.front()].first_violation, index};
    result.tally.merge(tally);
    if (config.progress) config.progress(double(result.cases) / double(config.cases));
  }
  result.seconds = seconds_since(start);
  return result;
}

std::optional<std::string> failure_of(const Subject& subject, Property property, const Case& on) {
  Tally tally;
  try {
    check_case_for(property, subject, on, tally);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (tally[property].violations == 0) return std::nullopt;
  return tally[property].first_violation;
}

Counterexample shrunk(const Subject& subject, const Counterexample& found, double seconds) {
  const auto start = Clock::now();
  Counterexample best = found;
  for (std::optional<Counterexample> next(found); next;) {
    next.reset();
    visit_simpler(best.on, [&](Case& candidate) {
      if (seconds_since(start) >= seconds) return true;
      if (auto failure = failure_of(subject, best.property, candidate))
        next = {best.property, std::move(candidate), std::move(*failure), best.index};
      return next.has_value();
    });
    if (next) best = *next;
  }
  return best;
}

} // namespace lightcuts::oracle
