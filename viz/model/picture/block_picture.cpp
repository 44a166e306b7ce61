// SPDX-License-Identifier: MIT
#include <viz/model/picture/block_picture.h>

#include <utility>

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <viz/model/picture/lit_square.h>

namespace lightcuts::viz {

BlockPicture::BlockPicture(FrameKey key)
    : Picture(key.scene->scene().image_size, false), key_(std::move(key)), view_(view_for(key_)),
      cut_(cut_config(key_.settings, *key_.scene, view_)), block_size_(pixel_count(), 0),
      proven_(pixel_count(), 0) {}

void BlockPicture::light_square(glm::uvec2 corner) {
  const auto index = [&](glm::uvec2 pixel) { return std::size_t(pixel.y) * size().x + pixel.x; };
  if (key_.method != methods::block_cuts) {
    for (const glm::uvec2 pixel : PixelSquare(view_, corner).pixels) block_size_[index(pixel)] = 1;
    return;
  }
  const LitSquare lit(view_, *key_.scene->tree(), cut_, key_.settings.seed, corner);
  for (std::size_t p = 0; p < lit.pixels().size(); ++p) {
    block_size_[index(lit.pixels()[p])] = float(lit.block(p).size());
    proven_[index(lit.pixels()[p])] = float(lit.proven(p));
  }
}

void BlockPicture::make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) {
  constexpr unsigned side = PixelSquare::side;
  const glm::uvec2 squares = (size() + (side - 1)) / side;
  tbb::parallel_for(0U, squares.x * squares.y, [&](unsigned i) {
    const glm::uvec2 corner = side * glm::uvec2(i % squares.x, i / squares.x);
    if (progress.cancelled() || !wanted(corner)) return; // squares are known as a whole
    light_square(corner);
    done({corner, glm::min(corner + side, size())});
  });
}

} // namespace lightcuts::viz
