// SPDX-License-Identifier: MIT
#include <viz/model/jobs/worker.h>

#include <utility>

#include <sys/resource.h>
#include <unistd.h>

namespace lightcuts::viz {
namespace {

// Of this thread alone on Linux; threads that it starts, such as oneTBB's, inherit it.
void give_way() {
  constexpr int background = 10;
  (void)::setpriority(PRIO_PROCESS, id_t(::gettid()), background); // no harm where it is refused
}

} // namespace

Worker::Worker(Niceness niceness)
    : niceness_(niceness), thread_([this](const std::stop_token& end) { run(end); }) {}

Worker::~Worker() {
  cancel();
  thread_.request_stop();
}

void Worker::start(Job job) {
  const std::lock_guard lock(mutex_);
  current_.request_stop();
  next_ = std::move(job);
  wake_.notify_one();
}

void Worker::cancel() {
  const std::lock_guard lock(mutex_);
  current_.request_stop();
  next_.reset();
}

bool Worker::busy() const {
  const std::lock_guard lock(mutex_);
  return running_ || next_;
}

void Worker::run(const std::stop_token& end) {
  if (niceness_ == Niceness::background) give_way();
  for (;;) {
    Job job;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      running_ = false;
      if (!wake_.wait(lock, end, [this] { return next_.has_value(); })) return;
      job = std::move(*next_);
      next_.reset();
      current_ = std::stop_source();
      stop = current_.get_token();
      running_ = true;
    }
    share_ = 0;
    job(Progress([this](double share) { share_ = share; },
                 [&stop] { return stop.stop_requested(); }));
  }
}

} // namespace lightcuts::viz
