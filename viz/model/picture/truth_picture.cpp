// SPDX-License-Identifier: MIT
#include <viz/model/picture/truth_picture.h>

#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <oracle/properties/judge.h>
#include <oracle/truth/clairvoyant.h>

namespace lightcuts::viz {

/// What a thread needs.
struct TruthPicture::State {
  std::unique_ptr<oracle::SubjectTree> tree;
  oracle::Truth truth;
  std::vector<char> visible;
};

TruthPicture::TruthPicture(FrameKey key)
    : Picture(key.scene->scene().image_size), key_(std::move(key)), view_(view_for(key_)),
      cut_(cut_config(key_.settings, *key_.scene, view_)), clairvoyant_(pixel_count(), 0),
      violations_(pixel_count(), 0) {}

void TruthPicture::judge(glm::uvec2 pixel, State& state) {
  const auto p = view_.at(pixel);
  if (!p) return;
  const LightSet& lights = key_.scene->scene().lights;
  state.visible.resize(lights.size());
  for (std::uint32_t i = 0; i < lights.size(); ++i) state.visible[i] = view_.sees(*p, i) ? 1 : 0;
  state.truth.evaluate(key_.scene->topology(), lights, p->point, state.visible);
  const oracle::PointCase at{0, p->point, state.visible, state.truth};
  const oracle::Judged judged{*state.tree, key_.scene->parts()};
  const std::size_t i = std::size_t(pixel.y) * size().x + pixel.x;
  // Where it is not known, a pixel that sees a surface has 1 all the same.
  clairvoyant_[i] = 1;
  const auto estimate = [&](std::uint32_t node) { return seen_estimate(judged, node, at); };
  if (judged.has(oracle::Part::bounds) && judged.has(oracle::Part::estimates))
    clairvoyant_[i] =
        float(clairvoyant_cut_size(state.truth, estimate, cut_.threshold, cut_.black_level));
  oracle::Tally tally;
  const oracle::Judge judge(judged.parts, 0, tally);
  const oracle::PointAnswers answers(judged, at);
  judge.clusters(answers);
  judge.cuts(answers, {&cut_, 1});
  violations_[i] = float(tally.violations());
}

void TruthPicture::make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) {
  tbb::enumerable_thread_specific<State> states([this] {
    return State{tree_for(key_.method, key_.settings, *key_.scene), {}, {}};
  });
  tbb::parallel_for(tbb::blocked_range<unsigned>(0, size().y), [&](const auto& rows) {
    State& state = states.local();
    for (unsigned y = rows.begin(); y < rows.end(); ++y)
      for (unsigned x = 0; x < size().x; ++x) {
        if (!wanted({x, y})) continue;
        if (progress.cancelled()) return;
        judge({x, y}, state);
        done({{x, y}, {x + 1, y + 1}});
      }
  });
}

} // namespace lightcuts::viz
