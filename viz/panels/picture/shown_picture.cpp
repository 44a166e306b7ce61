// SPDX-License-Identifier: MIT
#include <viz/panels/picture/shown_picture.h>

namespace lightcuts::viz {
namespace {

bool is_complete(const LayerSources& sources) {
  if (sources.truth) return sources.truth->complete();
  if (sources.blocks) return sources.blocks->complete();
  return sources.frame->complete() && (!sources.reference || sources.reference->complete());
}

} // namespace

void ShownPicture::refresh(Workbench& workbench, const Wish& wish) {
  const LayerSources sources = workbench.sources(wish.display, wish.layer);
  const Identity identity{sources.frame, sources.reference,       sources.truth, sources.blocks,
                          wish.layer,    workbench.state.colours, wish.exposure, wish.scale};
  const std::uint64_t source_version = version_of(wish.layer, sources);
  const bool same = identity == identity_ && version_ > 0;
  if (same && source_version == source_version_) return;
  const bool complete = is_complete(sources);
  if (same && !complete && seconds_since(made_) < patience) return;
  identity_ = identity;
  source_version_ = source_version;
  values_ = layer_values(wish.layer, sources);
  show();
}

void ShownPicture::refresh(const std::vector<glm::vec3>& image, glm::uvec2 size,
                           std::uint64_t version, const ColourSettings& colours,
                           std::optional<float> exposure) {
  const Identity identity{{}, {}, {}, {}, layers::image, colours, exposure, {}};
  if (identity == identity_ && version_ > 0 && version == source_version_) return;
  identity_ = identity;
  source_version_ = version;
  const std::vector<char> all(image.size(), 1);
  values_ = {.size = size, .image = image, .known = all, .own = all, .surface = all};
  show();
}

void ShownPicture::show() {
  coloured_ = viz::coloured(identity_.layer, values_, identity_.colours, identity_.exposure,
                            identity_.scale);
  texture_.upload(coloured_.size, coloured_.pixels);
  made_ = Clock::now();
  ++version_;
}

} // namespace lightcuts::viz
