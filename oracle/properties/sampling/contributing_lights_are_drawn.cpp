// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <oracle/properties/sampling/cluster_odds.h>

namespace lightcuts::oracle {

const PropertyInfo property::contributing_lights_are_drawn{
    .name = "contributing-lights-are-drawn",
    .statement = "A light that contributes is drawn with a probability above 0.",
    .formula = "probability > 0 wherever the contribution is",
    .needs = only(Part::sampling),
    .of_odds =
        [](const ClusterOdds& of, const Recorder& record) {
          for (std::size_t i = 0; i < of.lights.size(); ++i)
            record(of.p[i] > 0 || !of.shines(i), [&] {
              return fmt::format("{}: light {} of node {} contributes and is never drawn",
                                 of.point.at.text(), of.lights[i], of.node);
            });
        },
};

} // namespace lightcuts::oracle
