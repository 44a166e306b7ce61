// SPDX-License-Identifier: MIT
#include <viz/model/jobs/worker.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::ElementsAre;

void wait_for_stop(const Progress& progress) {
  comes_true([&] { return progress.cancelled(); });
}

TEST(Worker, DoesAJobOnAnotherThread) {
  Worker worker(Niceness::prompt);
  EXPECT_FALSE(worker.busy());
  std::atomic<bool> done = false;
  std::thread::id by;
  worker.start([&](const Progress& progress) {
    by = std::this_thread::get_id();
    done = !progress.cancelled();
  });
  ASSERT_TRUE(comes_true([&] { return done && !worker.busy(); }));
  EXPECT_NE(by, std::this_thread::get_id());
}

TEST(Worker, DoesOnlyTheLatestOfWhatWaits) {
  Worker worker(Niceness::prompt);
  std::vector<char> order;
  std::atomic<bool> begun = false, may_end = false;
  worker.start([&](const Progress& progress) {
    begun = true;
    wait_for_stop(progress);
    order.push_back('a');
    comes_true([&] { return may_end.load(); });
  });
  ASSERT_TRUE(comes_true([&] { return begun.load(); }));
  worker.start([&](const Progress&) { order.push_back('b'); });
  worker.start([&](const Progress&) { order.push_back('c'); });
  EXPECT_TRUE(worker.busy());
  may_end = true;
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_THAT(order, ElementsAre('a', 'c'));
}

TEST(Worker, CancelsWhatRunsAndWhatWaits) {
  Worker worker(Niceness::prompt);
  std::atomic<bool> begun = false, stopped = false, ran = false;
  worker.start([&](const Progress& progress) {
    begun = true;
    wait_for_stop(progress);
    stopped = progress.cancelled();
  });
  ASSERT_TRUE(comes_true([&] { return begun.load(); }));
  worker.start([&](const Progress&) { ran = true; });
  worker.cancel();
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(ran);
}

TEST(Worker, KeepsTheShareThatAJobTells) {
  Worker worker(Niceness::prompt);
  EXPECT_EQ(worker.share(), 0);
  worker.start([](const Progress& progress) { progress.report(0.5); });
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_EQ(worker.share(), 0.5);
  worker.start([](const Progress&) {});
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_EQ(worker.share(), 0) << "of the latest";
}

TEST(Worker, IsOfUseAfterCancelling) {
  Worker worker(Niceness::prompt);
  worker.cancel();
  std::atomic<int> runs = 0;
  worker.start([&](const Progress& progress) { runs += progress.cancelled() ? 100 : 1; });
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_EQ(runs, 1);
}

TEST(Worker, CancelsAndWaitsAtItsEnd) {
  std::atomic<bool> begun = false, stopped = false, returned = false;
  {
    Worker worker(Niceness::background);
    worker.start([&](const Progress& progress) {
      begun = true;
      wait_for_stop(progress);
      stopped = progress.cancelled();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      returned = true;
    });
    ASSERT_TRUE(comes_true([&] { return begun.load(); }));
  }
  EXPECT_TRUE(stopped);
  EXPECT_TRUE(returned);
}

int niceness_of_a_job(Niceness niceness) {
  Worker worker(niceness);
  std::atomic<int> found = -100;
  worker.start([&](const Progress&) { found = ::getpriority(PRIO_PROCESS, id_t(gettid())); });
  comes_true([&] { return !worker.busy(); });
  return found;
}

TEST(Worker, GivesWayToTheWindowInTheBackground) {
  const int own = ::getpriority(PRIO_PROCESS, id_t(gettid()));
  if (own >= 10) GTEST_SKIP() << "these tests give way themselves";
  EXPECT_EQ(niceness_of_a_job(Niceness::prompt), own);
  EXPECT_EQ(niceness_of_a_job(Niceness::background), 10);
}

} // namespace
} // namespace lightcuts::viz
