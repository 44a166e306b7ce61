// SPDX-License-Identifier: MIT
#include <viz/panels/app/frame_pacer.h>

#include <gtest/gtest.h>

namespace lightcuts::viz {
namespace {

using std::chrono::milliseconds;

/// One that has just drawn, and nothing has happened for long.
FramePacer rested(Clock::time_point now) {
  FramePacer pacer;
  for (int i = 0; i < 10; ++i) pacer.waited(1, 1);
  pacer.drawn(now - milliseconds(9), now);
  return pacer;
}

TEST(FramePacer, WaitsLongWhereNothingHappens) {
  const auto now = Clock::now();
  const FramePacer pacer = rested(now);
  EXPECT_DOUBLE_EQ(pacer.patience(false, now), FramePacer::idle);
  EXPECT_DOUBLE_EQ(pacer.patience(true, now), FramePacer::busy);
  EXPECT_NEAR(pacer.patience(true, now + milliseconds(40)), FramePacer::busy - 0.04, 1e-9);
  EXPECT_EQ(pacer.patience(true, now + milliseconds(400)), 0);
}

TEST(FramePacer, DrawsAFewFramesAtOnceAfterAnEvent) {
  const auto now = Clock::now();
  FramePacer pacer = rested(now);
  pacer.waited(FramePacer::idle, 0.1); // woken before the time
  int eager = 0;
  while (pacer.patience(false, now) <= FramePacer::fastest && eager < 100) {
    pacer.waited(FramePacer::fastest, FramePacer::fastest);
    ++eager;
  }
  EXPECT_GE(eager, 2); // what a frame asks for is seen in the next
  EXPECT_LE(eager, 5);
}

TEST(FramePacer, KeepsToItsFastestPace) {
  const auto now = Clock::now();
  FramePacer pacer;
  pacer.drawn(now - milliseconds(9), now);
  EXPECT_NEAR(pacer.patience(false, now), FramePacer::fastest - 0.009, 1e-9) << "drawing counts";
  pacer.drawn(now - milliseconds(200), now);
  EXPECT_EQ(pacer.patience(false, now), 0);
}

} // namespace
} // namespace lightcuts::viz
