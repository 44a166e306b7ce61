// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/hunt.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include <lightcuts/input_error.h>

namespace lightcuts::oracle {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How near a property is to the cause: violations before waste, then in the order of Property.
std::size_t distance_from_cause(Property property) {
  return std::size_t(property) + (info(property).severity == Severity::waste ? property_count : 0);
}

/// The property nearest to the cause that does not hold.
std::optional<Property> broken(const Tally& tally, bool waste) {
  std::optional<Property> nearest;
  for (std::size_t i = 0; i < property_count; ++i) {
    const Property p{static_cast<std::uint8_t>(i)};
    if (tally[p].violations == 0 || (!waste && info(p).severity == Severity::waste)) continue;
    if (!nearest || distance_from_cause(p) < distance_from_cause(*nearest)) nearest = p;
  }
  return nearest;
}

} // namespace

HuntResult hunt(const Subject& subject, const HuntConfig& config) {
  const auto start = Clock::now();
  const auto in_time = [&] { return config.seconds == 0 || seconds_since(start) < config.seconds; };
  HuntResult result;
  std::uint64_t end = config.cases;
  for (; result.cases < end && in_time(); ++result.cases) {
    const std::uint64_t index = result.cases;
    const Case on = random_case(config.seed, index);
    Tally tally;
    check_case(subject, on, index, tally);
    result.tally.merge(tally);
    if (config.progress) config.progress(double(index + 1) / double(config.cases));
    const auto property = broken(tally, config.waste);
    if (!property) continue;
    if (!result.found) {
      result.seconds = seconds_since(start);
      end = std::min(end, index + 1 + config.further);
    }
    if (!result.found ||
        distance_from_cause(*property) < distance_from_cause(result.found->property))
      result.found = {*property, on, tally[*property].first_violation, index};
  }
  if (!result.found) result.seconds = seconds_since(start);
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
