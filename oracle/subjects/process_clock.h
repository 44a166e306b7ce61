// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

namespace lightcuts::oracle {

/// Processor time that all threads of the process have had, seconds; 0 where it cannot be told.
[[nodiscard]] double processor_seconds(pid_t process);

/// Whether a thread of the process runs, waits for a processor or for the disk: not so where all of
/// them sleep, or it has ended.
[[nodiscard]] bool wants_processor(pid_t process);

} // namespace lightcuts::oracle
