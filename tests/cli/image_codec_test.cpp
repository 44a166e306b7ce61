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

} // namespace
} // namespace lightcuts
