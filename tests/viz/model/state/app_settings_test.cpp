// SPDX-License-Identifier: MIT
#include <viz/model/state/app_settings.h>

#include <cstdlib>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/support/every_field.h>
#include <tests/support/member_count.h>

namespace lightcuts::viz {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

AppSettings chosen_settings() {
  AppSettings s;
  s.window_size = {1920, 1017};
  s.details_share = 0.31F;
  s.tree_share = 0.17F;
  s.colour_map = ColourMap::viridis;
  s.recent = {"cloud?lights=7", "/home/me/a \"b\".obj"};
  return s;
}

TEST(AppSettings, PersistInAFolderThatIsMade) {
  const TemporaryFolder folder;
  const auto where = folder.path / "deep" / "lightcuts-viz";
  std::string problem;
  EXPECT_EQ(load_settings(where, problem), AppSettings());
  save_settings(chosen_settings(), where);
  EXPECT_EQ(load_settings(where, problem), chosen_settings());
  EXPECT_EQ(problem, "") << "no file at all is none, either";
}

TEST(AppSettings, ListAllTheirMembers) {
  EXPECT_EQ(field_count<AppSettings>(), member_count<AppSettings>());
}

TEST(AppSettings, PersistWithEveryFieldUnlikeItsDefault) {
  const TemporaryFolder folder;
  const auto all = unlike_default<AppSettings>();
  const auto leaves = leaves_of(all);
  for (const auto& [path, bits] : leaves_of(AppSettings{}))
    EXPECT_NE(leaves.at(path), bits) << path;
  save_settings(all, folder.path);
  std::string problem;
  EXPECT_EQ(leaves_of(load_settings(folder.path, problem)), leaves);
  EXPECT_EQ(problem, "");
}

TEST(AppSettings, NeedNoFolder) {
  std::string problem;
  save_settings(chosen_settings(), {});
  EXPECT_EQ(load_settings({}, problem), AppSettings());
  EXPECT_EQ(problem, "");
}

TEST(AppSettings, SurviveABrokenFile) {
  const TemporaryFolder folder;
  const auto file = folder.path / "settings.json";
  save_settings(chosen_settings(), folder.path);
  const std::string good = content_of(file);
  for (const std::string& bad :
       {std::string(), std::string("{}"), std::string("[1]"), good.substr(0, good.size() / 2),
        std::string(R"({"schema": "lightcuts-viz/settings/2"})"), std::string("\0\xff", 2)}) {
    write(file, bad);
    std::string problem;
    EXPECT_EQ(load_settings(folder.path, problem), AppSettings()) << bad;
    EXPECT_THAT(problem, HasSubstr(file.string())) << bad;
  }
}

TEST(AppSettings, SurviveMembersOfAnotherKind) {
  const TemporaryFolder folder;
  const auto file = folder.path / "settings.json";
  save_settings(chosen_settings(), folder.path);
  const std::string good = content_of(file);
  for (const auto& [from, to] :
       {std::pair("1920", "\"wide\""), std::pair("\"viridis\"", "\"jet\""),
        std::pair("\"cloud?lights=7\"", "7"), std::pair("\"tree_share\"", "\"treeshare\"")}) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), std::string(from).size(), to);
    write(file, bad);
    std::string problem;
    EXPECT_EQ(load_settings(folder.path, problem), AppSettings()) << to;
    EXPECT_NE(problem, "") << to;
  }
}

TEST(AppSettings, OpenAWindowThatCanBeUsed) {
  const TemporaryFolder folder;
  AppSettings mad = chosen_settings();
  mad.window_size = {1, 1'000'000};
  mad.details_share = -3;
  mad.tree_share = 40;
  mad.recent.assign(100, "cloud");
  save_settings(mad, folder.path);
  std::string problem;
  const AppSettings read = load_settings(folder.path, problem);
  EXPECT_EQ(problem, "");
  EXPECT_GE(read.window_size.x, 100);
  EXPECT_LE(read.window_size.y, 20'000);
  EXPECT_GT(read.details_share, 0);
  EXPECT_LT(read.tree_share, 1);
  EXPECT_THAT(read.recent, SizeIs(AppSettings::most_recent));
}

TEST(AppSettings, NameTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path / "file";
  write(file, "not a folder");
  expect_refusal(file.string(), [&] { save_settings({}, file); });
}

TEST(AppSettings, RememberTheLatestScenesEachOnce) {
  AppSettings s;
  for (const char* scene : {"a", "b", "c", "a"}) s.remember(scene);
  EXPECT_THAT(s.recent, ElementsAre("a", "c", "b"));
  s.remember(s.recent[1]); // as the menu of recent ones does
  EXPECT_THAT(s.recent, ElementsAre("c", "a", "b"));
  for (int i = 0; i < 30; ++i) s.remember(std::to_string(i));
  EXPECT_THAT(s.recent, SizeIs(AppSettings::most_recent));
  EXPECT_EQ(s.recent.front(), "29");
}

/// Sets an environment variable for a while.
class Environment {
public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Environment() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(ConfigFolder, IsWhereTheDesktopKeepsSettings) {
  const Environment home("HOME", "/home/me");
  {
    const Environment config("XDG_CONFIG_HOME", "/etc/mine");
    EXPECT_EQ(config_folder(), "/etc/mine/lightcuts-viz");
  }
  for (const char* value : {"", "relative", static_cast<const char*>(nullptr)}) {
    const Environment config("XDG_CONFIG_HOME", value);
    EXPECT_EQ(config_folder(), "/home/me/.config/lightcuts-viz");
  }
}

TEST(ConfigFolder, IsNoneWhereNothingIsKnown) {
  const Environment home("HOME", nullptr), config("XDG_CONFIG_HOME", nullptr);
  EXPECT_TRUE(config_folder().empty());
}

} // namespace
} // namespace lightcuts::viz
