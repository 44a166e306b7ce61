// SPDX-License-Identifier: MIT
#include <viz/model/picture/picture_queue.h>

#include <algorithm>
#include <utility>

namespace lightcuts::viz {
namespace {

/// The one with this key, moved to the end: those at the front are forgotten first.
template <class P>
std::shared_ptr<P> remembered(std::vector<std::shared_ptr<P>>& all, const FrameKey& key,
                              std::size_t most) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const auto& picture) { return picture->key() == key; });
  if (found != all.end()) {
    std::rotate(found, found + 1, all.end());
    return all.back();
  }
  if (all.size() >= most) {
    // Rather one of which nothing is known, as of a camera on its way.
    const auto blank = std::find_if(all.begin(), all.end(),
                                    [](const auto& picture) { return picture->share() == 0; });
    all.erase(blank == all.end() ? all.begin() : blank);
  }
  return all.emplace_back(std::make_shared<P>(key));
}

} // namespace

std::shared_ptr<Frame> PictureQueue::frame(const FrameKey& key) {
  return remembered(frames_, key, most_remembered);
}

std::shared_ptr<TruthPicture> PictureQueue::truth(const FrameKey& key) {
  return remembered(truths_, key, most_remembered);
}

std::shared_ptr<BlockPicture> PictureQueue::blocks(const FrameKey& key) {
  return remembered(blocks_, key, most_remembered);
}

void PictureQueue::want(std::vector<std::shared_ptr<Picture>> pictures) {
  if (pictures == wanted_) return;
  wanted_ = std::move(pictures);
  // The first of them alone has to go on where it did: the job begins again where it stopped.
  worker_.start([todo = wanted_](const Progress& progress) {
    for (const auto& picture : todo) {
      if (progress.cancelled()) return;
      if (!picture->complete()) picture->advance(progress);
    }
  });
}

bool PictureQueue::busy() const { return current() != nullptr; }

std::shared_ptr<Picture> PictureQueue::current() const {
  for (const auto& picture : wanted_)
    if (!picture->complete()) return picture;
  return nullptr;
}

void PictureQueue::clear() {
  wanted_.clear();
  worker_.cancel();
  frames_.clear();
  truths_.clear();
  blocks_.clear();
}

} // namespace lightcuts::viz
