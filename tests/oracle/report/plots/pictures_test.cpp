// SPDX-License-Identifier: MIT
#include <oracle/report/plots/pictures.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/version.h>

#include <tests/render/support/temporary_folder.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;

/// Two pixels, of which the second sees no surface.
Rendering rendering(const glm::vec3& radiance) {
  Rendering r;
  r.size = {2, 1};
  r.radiance = {radiance, glm::vec3(0)};
  r.certified_error = {{1, 2, 4}, glm::vec3(0)};
  r.emission = {{0.5F, 0, 0}, glm::vec3(0)};
  r.cut_size = {9, 0};
  r.shadow_rays = {8, 0};
  r.microseconds = {3, 1};
  r.end.resize(2, CutEnd::converged);
  r.surface_pixels = 1;
  return r;
}

const Rendering shown = rendering({1, 2, 3});
const Rendering reference = rendering({1.5F, 2, 2});

PictureSource source_of(const Rendering* with) { return {shown, with, 0, "desk", 5, 0.02F}; }

float at(const Film& film, const char* channel) { return film.channel(channel)[0]; }

TEST(FilmOf, HasEveryChannelThatIsDocumented) {
  EXPECT_THAT(film_of(source_of(&reference)).channel_names(),
              ElementsAre("R", "G", "B", "reference.R", "reference.G", "reference.B", "cut.size",
                          "cut.bound", "cut.error", "cut.slack", "rays.shadow", "time.us"));
  EXPECT_THAT(film_of(source_of(nullptr)).channel_names(),
              ElementsAre("R", "G", "B", "cut.size", "cut.bound", "rays.shadow", "time.us"));
}

TEST(FilmOf, HasTheValuesOfTheRendering) {
  const Film film = film_of(source_of(&reference));
  EXPECT_EQ(at(film, "R"), 1.5F); // with what the surface emits
  EXPECT_EQ(at(film, "G"), 2);
  EXPECT_EQ(at(film, "B"), 3);
  EXPECT_EQ(at(film, "reference.R"), 2);
  EXPECT_EQ(at(film, "reference.B"), 2);
  EXPECT_EQ(at(film, "cut.size"), 9);
  EXPECT_EQ(at(film, "cut.bound"), 7);
  EXPECT_EQ(at(film, "cut.error"), 1.5F);
  EXPECT_EQ(at(film, "cut.slack"), 7 / 1.5F);
  EXPECT_EQ(at(film, "rays.shadow"), 8);
  EXPECT_EQ(at(film, "time.us"), 3);
}

TEST(FilmOf, HasNoSlackWhereThereIsNoError) {
  const Film film = film_of(source_of(&shown));
  EXPECT_EQ(at(film, "cut.error"), 0);
  EXPECT_EQ(at(film, "cut.slack"), 0);
}

TEST(FilmOf, LeavesPixelsWithoutASurfaceBlack) {
  const Film film = film_of(source_of(&reference));
  for (const std::string& name : film.channel_names())
    if (name != "time.us") {
      EXPECT_EQ(film.channel(name)[1], 0) << name;
    }
}

TEST(FilmOf, SaysWhereItComesFrom) {
  const Film film = film_of(source_of(nullptr));
  EXPECT_EQ(film.metadata,
            (std::map<std::string, std::string>{
                {"scene", "desk"}, {"seed", "5"}, {"threshold", "0.02"}, {"version", version}}));
}

std::vector<std::string> names(const std::vector<std::pair<std::string, std::string>>& pictures) {
  std::vector<std::string> list;
  for (const auto& [caption, name] : pictures) {
    EXPECT_FALSE(caption.empty());
    list.push_back(name);
  }
  return list;
}

TEST(WritePictures, StagesWhatItLists) {
  const TemporaryFolder temporary;
  const auto final_folder = temporary.path / "out";
  OutputFolder folder(final_folder);
  const auto list = names(write_pictures(source_of(&reference), folder));
  EXPECT_THAT(list, ElementsAre("image.png", "reference.png", "cut-size.png", "shadow-rays.png",
                                "time.png", "error.png"));
  EXPECT_FALSE(exists(final_folder));
  folder.commit();
  for (const std::string& name : list)
    EXPECT_EQ(content_of(final_folder / name).substr(1, 3), "PNG") << name;
  EXPECT_TRUE(exists(final_folder / "image.exr"));
}

TEST(WritePictures, HasNoErrorsWithoutAReference) {
  const TemporaryFolder temporary;
  OutputFolder folder(temporary.path / "out");
  EXPECT_THAT(names(write_pictures(source_of(nullptr), folder)),
              ElementsAre("image.png", "cut-size.png", "shadow-rays.png", "time.png"));
  folder.commit();
  EXPECT_FALSE(exists(temporary.path / "out" / "error.png"));
}

TEST(WritePictures, WritesTheFilmAsExr) {
  const TemporaryFolder temporary;
  OutputFolder folder(temporary.path / "out");
  write_pictures(source_of(&reference), folder);
  folder.commit();
  const Film film = read_exr(temporary.path / "out" / "image.exr");
  EXPECT_EQ(at(film, "cut.bound"), 7);
  EXPECT_EQ(film.metadata.at("threshold"), "0.02");
}

TEST(WritePictures, CopesWithBlackness) {
  Rendering black = rendering(glm::vec3(0));
  for (auto* v : {&black.cut_size, &black.shadow_rays, &black.microseconds}) v->assign(2, 0);
  const TemporaryFolder temporary;
  OutputFolder folder(temporary.path / "out");
  write_pictures({black, &black, 0, "black", 1, 0}, folder);
  folder.commit();
  EXPECT_TRUE(exists(temporary.path / "out" / "error.png"));
}

} // namespace
} // namespace lightcuts::oracle
