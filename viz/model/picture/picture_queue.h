// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <viz/model/jobs/worker.h>
#include <viz/model/picture/block_picture.h>
#include <viz/model/picture/frame.h>
#include <viz/model/picture/truth_picture.h>

namespace lightcuts::viz {

/// Makes pictures in the background, those wanted most first, and remembers the last few.
class PictureQueue {
public:
  PictureQueue() : worker_(Niceness::background) {}

  /// The picture of the key, remembered or new; nothing of it is made yet.
  [[nodiscard]] std::shared_ptr<Frame> frame(const FrameKey& key);
  [[nodiscard]] std::shared_ptr<TruthPicture> truth(const FrameKey& key);
  [[nodiscard]] std::shared_ptr<BlockPicture> blocks(const FrameKey& key);

  /// Makes these, one after the other, and stops all else. Cheap where nothing has changed: to be
  /// called for every frame of the window.
  void want(std::vector<std::shared_ptr<Picture>> pictures);

  /// Whether some wanted picture is not complete.
  [[nodiscard]] bool busy() const;
  /// The first wanted picture that is not complete, or null.
  [[nodiscard]] std::shared_ptr<Picture> current() const;
  /// Forgets all pictures, and stops.
  void clear();

private:
  static constexpr std::size_t most_remembered = 16; ///< of each kind

  std::vector<std::shared_ptr<Frame>> frames_;
  std::vector<std::shared_ptr<TruthPicture>> truths_;
  std::vector<std::shared_ptr<BlockPicture>> blocks_;
  std::vector<std::shared_ptr<Picture>> wanted_;
  Worker worker_; ///< last: ends before what it works on
};

} // namespace lightcuts::viz
