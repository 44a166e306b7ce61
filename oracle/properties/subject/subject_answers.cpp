// SPDX-License-Identifier: MIT
#include <oracle/properties/properties.h>

namespace lightcuts::oracle {

// Checked by whatever else is: see Judge::answers().
const PropertyInfo property::subject_answers{
    .name = "subject-answers",
    .statement = "The subject does not crash, hang or answer what cannot be read.",
    .formula = "every call returns in time",
};

} // namespace lightcuts::oracle
