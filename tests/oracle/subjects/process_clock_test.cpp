// SPDX-License-Identifier: MIT
#include <oracle/subjects/process_clock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lightcuts::oracle {
namespace {

/// A process that does nothing but this, until the end.
template <class Work>
class Process {
public:
  explicit Process(Work work) : pid_(fork()) {
    if (pid_ == 0)
      for (;;) work();
  }
  ~Process() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  [[nodiscard]] pid_t pid() const { return pid_; }

private:
  pid_t pid_;
};

TEST(ProcessClock, TellsWhoWorksFromWhoSleeps) {
  const Process busy([] {});
  const Process idle([] { pause(); });
  // The one has had a while when the other has gone to sleep.
  for (int i = 0; i < 1000 && processor_seconds(busy.pid()) < 0.05; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_GE(processor_seconds(busy.pid()), 0.05);
  EXPECT_TRUE(wants_processor(busy.pid()));
  EXPECT_LT(processor_seconds(idle.pid()), 0.05);
  EXPECT_FALSE(wants_processor(idle.pid()));
}

TEST(ProcessClock, KnowsNothingOfWhoIsNot) {
  EXPECT_EQ(processor_seconds(-1), 0);
  EXPECT_FALSE(wants_processor(-1));
}

} // namespace
} // namespace lightcuts::oracle
