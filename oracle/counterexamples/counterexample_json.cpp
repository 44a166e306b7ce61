// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/counterexample_json.h>

#include <oracle/records/record_file.h>

namespace lightcuts::oracle {

std::string counterexample_json(const SavedCounterexample& saved) {
  return record_file(counterexample_schema, saved, Floats::hexadecimal);
}

} // namespace lightcuts::oracle
