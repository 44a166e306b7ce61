// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <oracle/properties/properties.h>

namespace lightcuts::oracle {
namespace {

/// Bounds to order: ties with infinity among them.
constexpr std::array<double, 6> keys{
    0, 0x1p-149, 1, 1 + 0x1p-23, 0x1.fffffep127, std::numeric_limits<double>::infinity()};

/// What is wrong with the order, or nothing.
std::string fault_in_order(const Subject& subject) {
  const auto before = [&](double a, double b) { return subject.refined_before(a, b); };
  const auto fault = [](double a, double b, const char* what) {
    return fmt::format("bounds {} and {}: {}", a, b, what);
  };
  for (const double a : keys)
    for (const double b : keys) {
      if (before(a, b) && before(b, a)) return fault(a, b, "each is refined before the other");
      for (const double c : keys) {
        if (before(a, b) && before(b, c) && !before(a, c))
          return fault(a, c, "not before, but something lies between");
        const bool ab = before(a, b) || before(b, a), bc = before(b, c) || before(c, b);
        if (!ab && !bc && (before(a, c) || before(c, a)))
          return fault(a, c, "differ, but both tie with a third");
      }
    }
  return {};
}

void check_strictness(const Subject& subject, const Recorder& record) {
  const std::string fault = fault_in_order(subject);
  record(fault.empty(), [&] { return fault; });
}

} // namespace

const PropertyInfo property::refinement_order_is_strict{
    .name = "refinement-order-is-strict",
    .statement = "The order in which clusters are refined is a strict one.",
    .formula = "not a < a, not a < b < a; neither a < b nor b < a is transitive; also for "
               "infinite bounds",
    .needs = only(Part::refinement_order),
    .of_subject = check_strictness,
};

} // namespace lightcuts::oracle
