// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/certified_error.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {

const PropertyInfo property::zero_threshold_is_exact{
    .name = "zero-threshold-is-exact",
    .statement = "With threshold 0 the estimate is exact but for rounding.",
    .formula = "|radiance - exact| <= 2^-23 exact + 2^-149, per channel",
    .needs = only(Part::cuts),
    .of_cut =
        [](const CutAnswer& of, const Recorder& record) {
          const PointCase& at = of.point.at;
          if (of.config.threshold != 0 || of.config.black_level != 0 ||
              of.config.max_size < at.lights().size())
            return;
          glm::vec3 limit;
          for (int c = 0; c < 3; ++c)
            limit[c] = certified_error(static_cast<double>(at.truth.seen(0)[c]), 0);
          check_against_truth(of, limit, record);
        },
};

} // namespace lightcuts::oracle
