// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/environment_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;

class EnvironmentMapFile : public testing::Test {
protected:
  /// Writes 3 x 2 pixels, value(channel, pixel) = 100 channel + pixel.
  std::filesystem::path write_channels(const std::vector<std::string>& names) {
    Film film({3, 2});
    for (std::size_t c = 0; c < names.size(); ++c)
      for (std::size_t i = 0; i < 6; ++i)
        film.channel(names[c])[i] = static_cast<float>(100 * c + i);
    write_exr(film, folder_.path / "sky.exr");
    return folder_.path / "sky.exr";
  }

  std::filesystem::path write_image(const std::string& name, const OIIO::ImageSpec& spec,
                                    const std::vector<float>& pixels) {
    const auto file = folder_.path / name;
    const auto output = OIIO::ImageOutput::create(file.string());
    EXPECT_TRUE(output && output->open(file.string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
    return file;
  }

  TemporaryFolder folder_;
};

TEST_F(EnvironmentMapFile, is_read_as_it_was_written) {
  const EnvironmentMap map = read_environment(write_channels({"R", "G", "B"}));
  EXPECT_EQ(map.size, glm::uvec2(3, 2));
  ASSERT_EQ(map.radiance.size(), 6U);
  EXPECT_EQ(map.radiance[0], glm::vec3(0, 100, 200));
  EXPECT_EQ(map.radiance[5], glm::vec3(5, 105, 205));
  EXPECT_THAT(map.name, HasSubstr("sky.exr"));
  EXPECT_TRUE(map.notes.empty());
}

TEST_F(EnvironmentMapFile, may_have_other_channels) {
  EXPECT_EQ(read_environment(write_channels({"A", "depth", "B", "G", "R"})).radiance[1],
            glm::vec3(401, 301, 201));
  EXPECT_EQ(read_environment(write_channels({"Y"})).radiance[1], glm::vec3(1));
}

TEST_F(EnvironmentMapFile, may_be_radiance_hdr) {
  const OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
  const EnvironmentMap map =
      read_environment(write_image("sky.hdr", spec, {1024, 512, 256, 0, 0, 0.5F}));
  EXPECT_EQ(map.radiance[0], glm::vec3(1024, 512, 256)); // powers of two survive its format
  EXPECT_EQ(map.radiance[1], glm::vec3(0, 0, 0.5F));
}

TEST_F(EnvironmentMapFile, of_integers_is_taken_as_linear_and_noted) {
  const OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  const EnvironmentMap map = read_environment(write_image("sky.png", spec, {1, 1, 1, 0, 0, 0.2F}));
  EXPECT_NEAR(map.radiance[1].b, 0.2, 0.002);
  EXPECT_THAT(map.notes,
              testing::ElementsAre(HasSubstr("sky.png: integer pixels taken as linear")));
}

// As a texture's are.
TEST_F(EnvironmentMapFile, has_pixels_that_are_no_radiance_clamped_and_says_so) {
  const auto clamped = [&](float value) {
    Film film({3, 2});
    for (const char* name : {"R", "G", "B"}) std::fill_n(film.channel(name).begin(), 6, 1.0F);
    film.channel("G")[4] = value;
    write_exr(film, folder_.path / "bad.exr");
    const EnvironmentMap map = read_environment(folder_.path / "bad.exr");
    EXPECT_THAT(map.notes, testing::ElementsAre(
                               HasSubstr("bad.exr: 1 pixel negative or not finite: clamped")));
    EXPECT_EQ(map.radiance[3], glm::vec3(1));
    return map.radiance[4];
  };
  EXPECT_EQ(clamped(std::numeric_limits<float>::quiet_NaN()), glm::vec3(1, 0, 1));
  EXPECT_EQ(clamped(-0.25F), glm::vec3(1, 0, 1));
  EXPECT_EQ(clamped(std::numeric_limits<float>::infinity()),
            glm::vec3(1, std::numeric_limits<float>::max(), 1));
}

TEST_F(EnvironmentMapFile, is_refused_where_it_is_a_pipe) {
  ASSERT_EQ(::mkfifo((folder_.path / "pipe.exr").c_str(), 0600), 0);
  expect_refusal("pipe.exr: cannot open: not a file",
                 [&] { (void)read_environment(folder_.path / "pipe.exr"); });
}

TEST_F(EnvironmentMapFile, is_refused_where_it_is_cropped) {
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
  spec.full_width = 4;
  const auto file = write_image("crop.exr", spec, {1, 1, 1, 1, 1, 1});
  expect_refusal("crop.exr: is cropped", [&] { (void)read_environment(file); });
}

TEST_F(EnvironmentMapFile, is_refused_where_it_is_too_wide) {
  const OIIO::ImageSpec spec(16385, 1, 1, OIIO::TypeDesc::FLOAT);
  const auto file = write_image("wide.exr", spec, std::vector<float>(16385, 1));
  expect_refusal("wide.exr: 16385 x 1 pixels, expected 1 to 16384 each",
                 [&] { (void)read_environment(file); });
}

TEST_F(EnvironmentMapFile, is_refused_where_it_cannot_be_read) {
  expect_refusal("absent.exr", [&] { (void)read_environment(folder_.path / "absent.exr"); });
  write(folder_.path / "text.exr", "not an image");
  expect_refusal("text.exr", [&] { (void)read_environment(folder_.path / "text.exr"); });
  write(folder_.path / "empty.hdr", "");
  expect_refusal("empty.hdr", [&] { (void)read_environment(folder_.path / "empty.hdr"); });
  const std::string whole = content_of(write_channels({"R", "G", "B"}));
  for (const std::size_t size : {whole.size() / 2, whole.size() - 8}) {
    write(folder_.path / "cut.exr", whole.substr(0, size));
    expect_refusal("cut.exr", [&] { (void)read_environment(folder_.path / "cut.exr"); });
  }
}

TEST(EnvironmentMap, needs_pixels) {
  expect_refusal("sky: 0 pixels for 0 x 0", [] { validate(EnvironmentMap{"sky", {}, {}, {}}); });
  expect_refusal("sky: 1 pixels for 2 x 2", [] {
    validate(EnvironmentMap{"sky", {2, 2}, {glm::vec3(1)}, {}});
  });
}

} // namespace
} // namespace lightcuts
