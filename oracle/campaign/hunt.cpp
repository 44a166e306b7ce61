// SPDX-License-Identifier: MIT
#include <oracle/campaign/hunt.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <unistd.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

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

/// What a case has shown.
struct Outcome {
  bool judged = false; ///< false: its lights are not for the subject
  std::size_t lights = 0;
  Tally tally;
};

/// Judges cases: of few lights, some ahead of the one that is asked for, on several threads.
class Outcomes {
public:
  Outcomes(const Subject& subject, const HuntConfig& config)
      : subject_(subject), config_(config),
        arena_(config.threads == 0 ? tbb::task_arena::automatic : int(config.threads)) {}

  /// index: ascending from call to call. Valid until the next call.
  const Outcome& at(std::uint64_t index) {
    if (many_lights_at(index) > 0) return large_ = outcome_of(index);
    if (index >= first_ + ahead_.size()) judge_from(index);
    return ahead_[std::size_t(index - first_)];
  }

private:
  [[nodiscard]] Outcome outcome_of(std::uint64_t index) const {
    const Case on = random_case(config_.seed, index);
    Outcome outcome{takes(subject_.parts(), on.lights), on.lights.size(), {}};
    if (outcome.judged) check_case(subject_, on, index, outcome.tally);
    return outcome;
  }
  void judge_from(std::uint64_t index) {
    first_ = index;
    constexpr std::uint64_t each = 32;
    const auto threads = std::uint64_t(arena_.max_concurrency());
    ahead_.assign(threads == 1 ? 1 : std::min(each * threads, config_.cases - index), {});
    arena_.execute([&] {
      tbb::parallel_for(std::size_t(0), ahead_.size(), [&](std::size_t i) {
        if (many_lights_at(first_ + i) == 0) ahead_[i] = outcome_of(first_ + i);
      });
    });
  }

  const Subject& subject_;
  const HuntConfig& config_;
  tbb::task_arena arena_;
  std::uint64_t first_ = 0;
  std::vector<Outcome> ahead_; ///< of first_ and what follows
  Outcome large_;
};

} // namespace

HuntResult hunt(const Subject& subject, const HuntConfig& config) {
  const auto start = Clock::now();
  const auto goes_on = [&] {
    const bool in_time = config.seconds == 0 || seconds_since(start) < config.seconds;
    return in_time && !config.progress.cancelled();
  };
  HuntResult result;
  Outcomes outcomes(subject, config);
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
    const double begun = clock();
    const Outcome& outcome = outcomes.at(index);
    if (!outcome.judged) continue;
    if (many > 0) ladder.went(many, clock() - begun);
    const Tally& tally = outcome.tally;
    result.most_lights = std::max(result.most_lights, outcome.lights);
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
      result.found = {property, random_case(config.seed, index), tally[property].first_violation,
                      index};
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
