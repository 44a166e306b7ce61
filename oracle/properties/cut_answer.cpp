// SPDX-License-Identifier: MIT
#include <oracle/properties/cut_answer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace lightcuts::oracle {

void check_against_truth(const CutAnswer& of, const glm::vec3& limit, const Recorder& record) {
  const Truth& truth = of.point.at.truth;
  const glm::vec3& radiance = of.cut.radiance;
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (limit[c] == std::numeric_limits<float>::infinity()) continue;
    const long double exact = truth.seen(0)[c];
    const long double error = std::abs(radiance[c] - exact);
    holds = holds && dominates(limit[c], error, (exact + error) * truth_error, [&]() -> Exact {
              return abs(Exact(radiance[c]) - truth.exact_seen(0, c));
            });
    worst = std::max(worst, ratio_of(error, limit[c]));
  }
  record(holds, worst, [&] {
    const Wide& exact = truth.seen(0);
    return fmt::format("{}: radiance {}, exact {}, allowed difference ({:.3g}, {:.3g}, {:.3g})",
                       of.point.at.text(), digits_of(radiance),
                       digits_of({exact[0], exact[1], exact[2]}), limit.x, limit.y, limit.z);
  });
}

} // namespace lightcuts::oracle
