// SPDX-License-Identifier: MIT
#include <oracle/subjects/process_clock.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace lightcuts::oracle {
namespace {

/// The state of a thread, as in proc(5): the letter after its name, which is in parentheses and may
/// have such itself.
char state_in(const std::filesystem::path& stat) {
  std::ifstream file(stat);
  std::string line;
  std::getline(file, line);
  const std::size_t end = line.rfind(')');
  return end == std::string::npos || end + 2 >= line.size() ? '?' : line[end + 2];
}

} // namespace

double processor_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (process <= 0 || clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0)
    return 0;
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

bool wants_processor(pid_t process) {
  std::error_code error;
  const std::filesystem::path tasks = fmt::format("/proc/{}/task", process);
  for (std::filesystem::directory_iterator i(tasks, error), end; !error && i != end;
       i.increment(error)) {
    const char state = state_in(i->path() / "stat");
    if (state == 'R' || state == 'D') return true;
  }
  return false;
}

} // namespace lightcuts::oracle
