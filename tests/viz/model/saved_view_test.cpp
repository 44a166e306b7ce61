// SPDX-License-Identifier: MIT
#include <viz/model/saved_view.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>
#include <lightcuts/version.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/viz/support/settled_workbench.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

Coloured shown_by(Workbench& bench) {
  const ViewState& state = bench.state;
  const LayerSources sources = bench.sources(state.display, state.layer);
  return coloured(state.layer, layer_values(state.layer, sources), state.colours);
}

TEST(FilmOf, HasTheLayersThatWereMade) {
  SmallWorkbench bench;
  bench.state.layer = layers::error;
  settle(bench);
  const Film film = film_of(bench, {});
  EXPECT_EQ(film.size(), glm::uvec2(32, 24));
  const auto frame = made<Frame>(small_key());
  const Rendering& r = frame->rendering();
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    ASSERT_EQ(film.channel("G")[i], r.radiance[i].y + r.emission[i].y);
    ASSERT_EQ(film.channel("cut-size")[i], r.cut_size[i]);
  }
  const auto values =
      layer_values(layers::error, bench.sources(methods::lightcuts, layers::error)).values;
  for (std::size_t i = 0; i < film.pixel_count(); ++i)
    ASSERT_EQ(film.channel("error")[i], values[i]);
  for (const char* name : {"R", "B", "shadow-rays", "certified-error", "slack", "time"})
    EXPECT_THAT(film.channel_names(), Contains(name));
  EXPECT_THAT(film.channel_names(), Not(Contains("clairvoyant"))) << "nobody asked for it";
}

TEST(FilmOf, SaysWhatItIs) {
  SmallWorkbench bench;
  bench.state.display = methods::paper;
  settle(bench);
  const Film film = film_of(bench, {});
  EXPECT_EQ(film.metadata.at("scene"), small_spec);
  EXPECT_EQ(film.metadata.at("method"), "paper");
  EXPECT_EQ(film.metadata.at("threshold"), "0.1");
  EXPECT_EQ(film.metadata.at("version"), version);
}

TEST(FilmOf, IsNotANumberWhereNothingIsKnown) {
  SmallWorkbench bench;
  bench.holds_pictures = true;
  settle(bench);
  const Film film = film_of(bench, {});
  EXPECT_THAT(film.channel_names(), testing::ElementsAre("R", "G", "B"));
  for (const float v : film.channel("R")) EXPECT_TRUE(std::isnan(v));
}

TEST(FilmOf, HasNoPixelInPlaceOfAnother) {
  SmallWorkbench bench;
  bench.holds_pictures = true;
  settle(bench);
  const auto frame =
      std::const_pointer_cast<Frame>(bench.sources(methods::lightcuts, layers::image).frame);
  frame->advance(Progress::until([&] { return frame->share() >= 4.0 / (32 * 24); }));
  const Film film = film_of(bench, {});
  for (unsigned i = 0; i < 32 * 24; ++i) {
    const bool coarse = i % 32 % 16 == 0 && i / 32 % 16 == 0;
    EXPECT_EQ(!std::isnan(film.channel("R")[i]), coarse) << i;
    EXPECT_EQ(!std::isnan(film.channel("cut-size")[i]), coarse) << i;
  }
}

TEST(SaveView, WritesThePictureTheNumbersAndTheState) {
  const TemporaryFolder folder;
  SmallWorkbench bench;
  bench.state.layer = layers::cut_size;
  bench.state.pixel = some_pixels[0];
  settle(bench);
  const auto where = folder.path / "views";
  save_view(bench, shown_by(bench), {}, where, "mine");
  EXPECT_EQ(load_view_state(where / "mine.json"), bench.state);
  const Film film = read_exr(where / "mine.exr");
  EXPECT_EQ(film.size(), glm::uvec2(32, 24));
  EXPECT_THAT(film.channel_names(), Contains("cut-size"));
  EXPECT_EQ(content_of(where / "mine.png").substr(1, 3), "PNG");
}

TEST(SaveView, OpensAsItWasSaved) {
  const TemporaryFolder folder;
  SmallWorkbench bench;
  bench.state.display = methods::stochastic;
  bench.state.shading.seed = 7;
  bench.state.camera = small_scene()->scene().camera;
  bench.state.camera->vertical_fov = 33;
  settle(bench);
  save_view(bench, shown_by(bench), {}, folder.path, "mine");
  Workbench again;
  again.state = load_view_state(folder.path / "mine.json");
  settle(again);
  EXPECT_EQ(shown_by(again).pixels, shown_by(bench).pixels);
}

TEST(SaveView, WritesAllOrNothing) {
  const TemporaryFolder folder;
  SmallWorkbench bench;
  settle(bench);
  Coloured broken = shown_by(bench);
  broken.size = {0, 0};
  broken.pixels.clear();
  EXPECT_THROW(save_view(bench, broken, {}, folder.path / "new", "mine"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path / "new" / "mine.json"));
  write(folder.path / "file", "not a folder");
  expect_refusal("file",
                 [&] { save_view(bench, shown_by(bench), {}, folder.path / "file", "mine"); });
}

} // namespace
} // namespace lightcuts::viz
