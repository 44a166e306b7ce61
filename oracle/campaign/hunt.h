// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <lightcuts/core/jobs/progress.h>
#include <oracle/properties/judge.h>

namespace lightcuts::oracle {

struct HuntConfig {
  std::uint64_t seed = 1;
  std::uint64_t cases = 10'000; ///< at most; default 10 000
  double seconds = 0;           ///< at most; 0: no limit. Default 0
  bool waste = true;            ///< whether waste counts as found; default true
  std::uint64_t further = 0;    ///< cases judged after the first that fails, in search of one that
                                ///< fails a property nearer to the cause; default 0
  unsigned threads = 1;         ///< 0: one per core; the result is the same. Default 1
  Progress progress;            ///< asked before each case whether to end, and told after it
};

/// A case on which a property does not hold, and what check_case() said of it.
struct Counterexample {
  Property property{};
  Case on;
  std::string message;
  std::uint64_t index = 0; ///< of the random case it comes from
  /// Where it takes more than 100 lights: how many there are, if with one less the property was
  /// found to hold, whether the first, the middle or the last of them was left out. 0: not known.
  std::uint32_t least_lights = 0;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("property", &Counterexample::property);
    field("message", &Counterexample::message);
    field("index", &Counterexample::index);
    field("case", &Counterexample::on);
    field("least_lights", &Counterexample::least_lights, domain::optional);
  }
};

struct HuntResult {
  Tally tally;                 ///< of all cases up to the one where something was found
  std::uint64_t cases = 0;     ///< judged, or left out since so many lights would take too long
  std::size_t most_lights = 0; ///< of a case that was judged
  std::optional<Counterexample> found;
  double seconds = 0; ///< until the first case that fails, or until the end
};

/// Judges the subject on one random case after another, until a property does not hold. Of several,
/// violations come before waste, and then the order of Property: what is wrong with the tree before
/// what is wrong with bounds, and that before cuts. The same for any number of processors, but for
/// `seconds`, and for cases of many lights that are left out: where a subject that takes N^3 would
/// need more than 10 s, going by the last ones.
[[nodiscard]] HuntResult hunt(const Subject& subject, const HuntConfig& config);

/// A counterexample of the same property, as simple as can be found in so many seconds: given time
/// enough, no simpler() case of it fails. That it takes so many lights is looked into at the end,
/// which takes the time that three such cases take; not at all in 0 seconds.
[[nodiscard]] Counterexample shrunk(const Subject& subject, const Counterexample& found,
                                    double seconds = 10);

/// What check_case() says of the property on the case; nothing where it holds, or where the case
/// is not valid.
[[nodiscard]] std::optional<std::string> failure_of(const Subject& subject, Property property,
                                                    const Case& on);

} // namespace lightcuts::oracle
