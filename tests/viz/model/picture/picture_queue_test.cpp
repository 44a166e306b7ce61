// SPDX-License-Identifier: MIT
#include <viz/model/picture/picture_queue.h>

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/viz/support/made_up_picture.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

std::shared_ptr<MadeUpPicture> made_up() { return std::make_shared<MadeUpPicture>(glm::uvec2(8)); }

/// One that is made only after open() has been called.
class Gate {
public:
  explicit Gate(MadeUpPicture& picture) {
    picture.before_pixel = [this] {
      reached_ = true;
      comes_true([this] { return open_.load(); });
    };
  }
  void open() { open_ = true; }
  [[nodiscard]] bool reached() const {
    return comes_true([this] { return reached_.load(); });
  }

private:
  std::atomic<bool> open_ = false, reached_ = false;
};

FrameKey key_with_seed(std::uint64_t seed) {
  ShadingSettings settings = always_cuts();
  settings.seed = seed;
  return small_key(methods::stochastic, settings);
}

TEST(PictureQueue, RemembersThePicturesOfAKey) {
  PictureQueue queue;
  const auto frame = queue.frame(small_key());
  EXPECT_EQ(frame->key(), small_key());
  EXPECT_EQ(frame->share(), 0);
  EXPECT_EQ(queue.frame(small_key()), frame);
  EXPECT_NE(queue.frame(small_key(methods::paper)), frame);
  const auto truth = queue.truth(small_key());
  EXPECT_EQ(queue.truth(small_key()), truth);
  queue.clear();
  EXPECT_NE(queue.frame(small_key()), frame);
  EXPECT_NE(queue.truth(small_key()), truth);
}

TEST(PictureQueue, ForgetsThePictureThatWasNotAskedForForLongest) {
  PictureQueue queue;
  const auto first = queue.frame(key_with_seed(1)), second = queue.frame(key_with_seed(2));
  for (std::uint64_t seed = 3; seed <= 16; ++seed) (void)queue.frame(key_with_seed(seed));
  EXPECT_EQ(queue.frame(key_with_seed(1)), first);
  (void)queue.frame(key_with_seed(17));
  EXPECT_EQ(queue.frame(key_with_seed(1)), first);
  EXPECT_NE(queue.frame(key_with_seed(2)), second);
}

TEST(PictureQueue, MakesFirstWhatIsWantedFirst) {
  PictureQueue queue;
  const auto a = made_up(), b = made_up();
  Gate gate(*a);
  queue.want({a, b});
  EXPECT_TRUE(queue.busy());
  ASSERT_TRUE(gate.reached());
  EXPECT_EQ(queue.current(), a);
  EXPECT_EQ(b->share(), 0);
  b->before_pixel = [&] { EXPECT_TRUE(a->complete()); };
  gate.open();
  ASSERT_TRUE(comes_true([&] { return b->complete(); }));
  EXPECT_FALSE(queue.busy());
  EXPECT_EQ(queue.current(), nullptr);
}

TEST(PictureQueue, DropsWhatIsNotWantedAnyMoreAndGoesOnWithItLater) {
  PictureQueue queue;
  const auto a = made_up(), b = made_up();
  Gate gate(*a);
  queue.want({a});
  ASSERT_TRUE(gate.reached());
  queue.want({b});
  EXPECT_EQ(queue.current(), b);
  gate.open();
  ASSERT_TRUE(comes_true([&] { return b->complete(); }));
  EXPECT_FALSE(a->complete());
  EXPECT_FALSE(queue.busy()) << "nobody wants the other one";
  queue.want({a, b});
  ASSERT_TRUE(comes_true([&] { return a->complete(); }));
  EXPECT_THAT(a->times, testing::Each(1));
}

TEST(PictureQueue, StopsWhereNothingIsWanted) {
  for (const bool clears : {false, true}) {
    PictureQueue queue;
    const auto a = made_up();
    Gate gate(*a);
    queue.want({a});
    ASSERT_TRUE(gate.reached());
    if (clears)
      queue.clear();
    else
      queue.want({});
    EXPECT_FALSE(queue.busy());
    gate.open();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(a->complete());
  }
}

TEST(PictureQueue, GoesOnUndisturbedWhileTheSameIsWanted) {
  PictureQueue queue;
  const auto a = made_up();
  a->before_pixel = [] { std::this_thread::sleep_for(std::chrono::microseconds(200)); };
  ASSERT_TRUE(comes_true([&] {
    queue.want({a});
    return a->complete();
  }));
  EXPECT_EQ(a->calls, int(Picture::steps.size())) << "once per pass";
}

TEST(PictureQueue, GoesOnWithTheNextWhereOneFails) {
  PictureQueue queue;
  const auto a = made_up(), b = made_up();
  a->before_pixel = [] { throw std::runtime_error("out of luck"); };
  queue.want({a, b});
  ASSERT_TRUE(comes_true([&] { return !queue.busy(); }));
  EXPECT_EQ(a->failure(), "out of luck");
  EXPECT_EQ(b->share(), 1);
}

TEST(PictureQueue, MakesFramesAndTruthsOfAScene) {
  PictureQueue queue;
  const auto frame = queue.frame(small_key());
  const auto truth = queue.truth(small_key());
  queue.want({truth, frame});
  ASSERT_TRUE(comes_true([&] { return !queue.busy(); }));
  EXPECT_EQ(frame->rendering().radiance, made<Frame>(small_key())->rendering().radiance);
  EXPECT_EQ(truth->clairvoyant(), made<TruthPicture>(small_key())->clairvoyant());
}

} // namespace
} // namespace lightcuts::viz
