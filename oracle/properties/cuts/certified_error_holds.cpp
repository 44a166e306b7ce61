// SPDX-License-Identifier: MIT
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {

const PropertyInfo property::certified_error_holds{
    .name = "certified-error-holds",
    .statement = "The estimate differs from the truth by no more than it certifies.",
    .formula = "|radiance - exact| <= certified error, per channel",
    .needs = only(Part::cuts),
    .of_cut =
        [](const CutAnswer& of, const Recorder& record) {
          check_against_truth(of, of.cut.certified_error, record);
        },
};

} // namespace lightcuts::oracle
