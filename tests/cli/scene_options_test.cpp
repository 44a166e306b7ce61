// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;

const std::string floor_obj = "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nf 1 2 3 4\n";

class SceneOptions : public testing::Test {
protected:
  SceneOptions() { write(oracle_.folder() / "floor.obj", floor_obj); }

  OracleProcess oracle_;
};

TEST_F(SceneOptions, CameraIsPrintedSoThatItCanBeGivenAgain) {
  const std::string own = oracle_.run({"info", "floor.obj"}).out;
  const std::size_t at = own.find("--camera ");
  ASSERT_NE(at, std::string::npos) << own;
  const std::string camera = own.substr(at + 9, own.find('\n', at) - at - 9);
  EXPECT_THAT(oracle_.run({"info", "floor.obj", "--camera", camera}).out,
              HasSubstr("--camera " + camera + "\n"));
  EXPECT_THAT(oracle_.run({"info", "floor.obj", "--camera", "1,2.5,-3,0,0,1e-3"}).out,
              HasSubstr("--camera 1,2.5,-3,0,0,0.001,45\n"));
  // Straight down.
  const Outcome down =
      oracle_.run({"info", "floor.obj", "--camera", "0,5,0,0,0,0,20", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(down.out).at("camera"), "0,5,0,0,0,0,20");
}

TEST_F(SceneOptions, CameraThatIsNoneIsAUsageError) {
  for (const char* bad :
       {"", "1,2,3", "1,2,3,4,5", "1,2,3,4,5,6,7,8", "a,b,c,d,e,f", "1,2,3,1,2,3", "1,2,3,4,5,6,0",
        "1,2,3,4,5,6,180", "1,2,3,4,5,nan", "1,2,3,4,5,1e99", "1,2,3,4,5,6,"}) {
    const Outcome outcome = oracle_.run({"info", "floor.obj", "--camera", bad});
    EXPECT_EQ(outcome.exit_code, 2) << bad;
    EXPECT_THAT(outcome.err, HasSubstr("--camera")) << bad;
  }
}

TEST_F(SceneOptions, FilesOutsideTheFolderAreReadOnlyWhereThatIsAllowed) {
  std::filesystem::create_directory(oracle_.folder() / "sub");
  write(oracle_.folder() / "sub/s.json", R"({"geometry": "../floor.obj"})");
  const Outcome refused = oracle_.run({"info", "sub/s.json"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("sub/s.json: /geometry '../floor.obj': lies outside the "
                                     "scene's folder; --allow-outside allows it"));
  EXPECT_EQ(oracle_.run({"info", "sub/s.json", "--allow-outside"}).exit_code, 0);
  std::filesystem::create_symlink("../floor.obj", oracle_.folder() / "sub/link.obj");
  write(oracle_.folder() / "sub/s.json", R"({"geometry": "link.obj"})");
  EXPECT_EQ(oracle_.run({"info", "sub/s.json"}).exit_code, 3);
}

TEST_F(SceneOptions, SceneThatNeverEndsIsRefused) {
  ASSERT_EQ(::mkfifo((oracle_.folder() / "pipe.obj").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", oracle_.folder() / "zero.gltf");
  std::filesystem::create_symlink("/dev/zero", oracle_.folder() / "zero.json");
  for (const char* scene : {"pipe.obj", "zero.gltf", "zero.json"}) {
    const Outcome outcome = oracle_.run({"info", scene});
    EXPECT_EQ(outcome.exit_code, 3) << scene;
    EXPECT_EQ(outcome.err, std::string("lightcuts-oracle: ") + scene +
                               ": cannot open: a device or a pipe, not a file\n");
  }
}

} // namespace
} // namespace lightcuts
