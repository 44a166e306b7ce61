// SPDX-License-Identifier: MIT
#include <oracle/campaign/hunt.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <unistd.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <oracle/campaign/ladder.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/simpler_case.h>
#include <oracle/subjects/process_clock.h>

namespace lightcuts::oracle {
namespace {

/// How near a property is to the cause; see broken().
std::size_t distance_from_cause(const Subject& subject, Property property) {
  const bool waste = severity_of(property, subject.parts()) == Severity::waste;
  return std::size_t(property) + (waste ? property_count : 0);
}

/// See Counterexample::least_lights.
std::uint32_t least_lights_of(const Subject& subject, const Counterexample& c) {
  constexpr std::uint32_t few = 100;
  const auto count = std::uint32_t(c.on.lights.size());
  if (count <= few) return 0;
  const std::array without{0U, count / 2, count - 1};
  const bool hold = std::none_of(without.begin(), without.end(), [&](std::uint32_t light) {
    return failure_of(subject, c.property, without_lights(c.on, light, 1)).has_value();
  });
  return hold ? count : 0;
}

} // namespace

HuntResult hunt(const Subject& subject, const HuntConfig& config) {
  const auto start = Clock::now();
  const auto goes_on = [&] {
    const bool in_time = config.seconds == 0 || seconds_since(start) < config.seconds;
    return in_time && !config.progress.cancelled();
  };
  HuntResult result;
  Ladder ladder;
  // Where the machine is busy, wall time says little of the subject.
  const auto clock = [&, begun = Clock::now()] {
    return subject.works_elsewhere() ? seconds_since(begun) : processor_seconds(getpid());
  };
  std::uint64_t end = config.cases;
  for (; result.cases < end && goes_on(); ++result.cases) {
    const std::uint64_t index = result.cases;
    const std::uint32_t many = many_lights_at(index);
    // Once something is found, large cases would say the same at a hundred times the price.
    if (many > 0 && (result.found || !ladder.dares(many))) continue;
    const Case on = random_case(config.seed, index);
    if (!takes(subject.parts(), on.lights)) continue;
    Tally tally;
    const double begun = clock();
    check_case(subject, on, index, tally);
    if (many > 0) ladder.went(many, clock() - begun);
    result.most_lights = std::max(result.most_lights, on.lights.size());
    result.tally.merge(tally);
    config.progress.report(double(index + 1) / double(config.cases));
    const std::vector<Property> list = broken(tally);
    if (list.empty() || (!config.waste && tally[list.front()].severity == Severity::waste))
      continue;
    const Property property = list.front();
    if (!result.found) {
      result.seconds = seconds_since(start);
      end = std::min(end, index + 1 + config.further);
    }
    if (!result.found || distance_from_cause(subject, property) <
                             distance_from_cause(subject, result.found->property))
      result.found = {property, on, tally[property].first_violation, index};
  }
  if (!result.found) result.seconds = seconds_since(start);
  return result;
}

std::optional<std::string> failure_of(const Subject& subject, Property property, const Case& on) {
  Tally tally;
  try {
    check_case(subject, on, 0, tally, property);
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
  if (seconds > 0) best.least_lights = least_lights_of(subject, best);
  return best;
}

} // namespace lightcuts::oracle
