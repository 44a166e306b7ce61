// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ImageCodec, IsNotLoadedWithTheProgram) {
  // The loader lists the libraries instead of running the program, as for ldd.
  ::setenv("LD_TRACE_LOADED_OBJECTS", "1", 1);
  const Outcome libraries = OracleProcess().run({});
  ::unsetenv("LD_TRACE_LOADED_OBJECTS");
  EXPECT_THAT(libraries.out, HasSubstr("libembree"));
  EXPECT_THAT(libraries.out, Not(HasSubstr("OpenImageIO")));
}

TEST(ImageCodec, IsMissedOnlyWhereAnImageIsTouched) {
  const OracleProcess oracle;
  // The module beside the program comes before the one where it was built.
  const std::filesystem::path program = oracle.folder() / "lightcuts-oracle";
  std::filesystem::copy_file(LIGHTCUTS_ORACLE, program);
  write(oracle.folder() / "lightcuts_image_codec.so", "not a library");
  const auto run = [&](const std::vector<std::string>& arguments) {
    const auto out = oracle.folder() / "stdout", err = oracle.folder() / "stderr";
    return OracleProcess::outcome_of(oracle.start(program, arguments, out, err), out, err);
  };
  EXPECT_EQ(run({"info", "desk"}).exit_code, 0);
  EXPECT_EQ(run({"check", "desk", "--cases", "1000"}).exit_code, 0);
  const Outcome rendered = run({"render", "desk", "--size", "4x3"});
  EXPECT_EQ(rendered.exit_code, 3);
  EXPECT_THAT(rendered.err, HasSubstr("images cannot be read or written without the module"));
  EXPECT_THAT(rendered.err, HasSubstr("lightcuts_image_codec.so"));
  EXPECT_FALSE(std::filesystem::exists(oracle.folder() / "out"));
}

TEST(ImageCodec, LeavesWhatIsSaidOfABrokenImageToTheMessage) {
  const OracleProcess oracle;
  write(oracle.folder() / "bad.png", "\x89PNG\r\n\x1a\n" + std::string(40, '\1'));
  write(oracle.folder() / "bad.mtl", "newmtl a\nmap_Kd bad.png\n");
  write(oracle.folder() / "bad.obj", "mtllib bad.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                                     "usemtl a\nf 1/1 2/1 3/1\n");
  const Outcome outcome = oracle.run({"info", "bad.obj"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, testing::MatchesRegex("bad: bad.obj: texture 'bad.png' cannot be read: "
                                                 "PNG read error: [^\n]*\n"
                                                 "bad: bad.obj: no camera [^\n]*\n"));
}

} // namespace
} // namespace lightcuts
