// SPDX-License-Identifier: MIT
#include <oracle/campaign/catalogue_run.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <lightcuts/core/jobs/seconds_since.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/each_view.h>

namespace lightcuts::oracle {
namespace {

template <class Vector>
std::uint64_t infinities(const Vector& v) {
  return std::uint64_t(std::isinf(v.x)) + std::uint64_t(std::isinf(v.y)) +
         std::uint64_t(std::isinf(v.z));
}

/// What is measured at the case's views, beside what is judged.
class Measures {
public:
  Measures(const Case& on, NamedResult& result) : on_(on), result_(result) {}

  void take(const PointAnswers& of) {
    if (of.judged.has(Part::bounds))
      for (const glm::vec3& bound : of.bounds()) result_.saturated += infinities(bound);
    if (of.judged.has(Part::bounds) && of.judged.has(Part::estimates)) take_single_lights(of);
    if (!of.judged.has(Part::cuts)) return;
    const Cut cut = of.select(on_.cut);
    result_.saturated += infinities(cut.radiance);
    result_.most_clusters = std::max(result_.most_clusters, cut.clusters.size());
    if (on_.lights.size() > many_lights) return;
    const glm::vec3 exact = of.select(exact_cut(on_.lights.size())).radiance;
    compare(glm::dvec3(exact), of.at.truth.seen(0));
  }

private:
  void take_single_lights(const PointAnswers& of) {
    constexpr int most = 4096;
    int taken = 0;
    for (std::uint32_t i = of.topology().size(); i-- > 0 && taken < most;) {
      if (of.topology().light_count(i) != 1) continue;
      compare(of.open_estimate(i), of.at.truth.open(i));
      ++taken;
    }
  }

  void compare(const glm::dvec3& value, const Wide& truth) {
    for (int c = 0; c < 3; ++c) {
      const long double exact = truth[std::size_t(c)];
      if (exact < std::numeric_limits<float>::min() || std::isinf(value[c])) continue;
      const auto error = static_cast<double>(std::abs(value[c] - exact) / exact);
      result_.max_relative_error = std::max(result_.max_relative_error.value_or(0), error);
    }
  }

  const Case& on_;
  NamedResult& result_;
};

void measure_case(const Subject& subject, const Case& on, NamedResult& result) {
  const LightSet lights = on.light_set();
  if (lights.empty()) return;
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, on.seed);
  const TopologyReading reading = read_topology(tree->claim(), lights.size());
  if (!reading.topology) return; // convicted already
  const Judged judged{*tree, subject.parts()};
  Measures measures(on, result);
  for_each_view(on, *reading.topology, lights, 0, [&](std::size_t, const PointCase& at) {
    measures.take(PointAnswers(judged, at));
    return lights.size() > many_lights; // of many, one view will do
  });
}

} // namespace

NamedResult judge_named(const Subject& subject, const NamedCase& named, std::uint64_t place) {
  const auto start = Clock::now();
  const Case on = complete(named);
  NamedResult result{.of = &named, .lights = on.lights.size()};
  check_case(subject, on, place, result.tally);
  try {
    measure_case(subject, on, result);
  } catch (const SubjectFailure&) { // counted by check_case() where the subject fails each time
    Judge(subject.parts(), place, result.tally).answers([&] { measure_case(subject, on, result); });
  }
  for (const Property p : all_properties) {
    result.checks += result.tally[p].cases;
    result.worst_ratio = std::max(result.worst_ratio, result.tally[p].worst_ratio);
  }
  result.seconds = seconds_since(start);
  return result;
}

} // namespace lightcuts::oracle
