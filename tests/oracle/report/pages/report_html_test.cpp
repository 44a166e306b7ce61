// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_html.h>

#include <cstdlib>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include <tests/oracle/support/contains.h>
#include <tests/oracle/support/made_up_report.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts::oracle {
namespace {

/// The first tag that is not closed where it should be; empty where all are.
std::string unbalanced_tag(const std::string& html) {
  static const std::set<std::string> void_tags = {"meta", "img", "br", "hr"};
  static const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator t(html.begin(), html.end(), tag), end; t != end; ++t) {
    const std::string name = (*t)[2];
    if ((*t)[3].length() > 0 || void_tags.count(name) > 0) continue;
    if ((*t)[1].length() == 0)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return "/" + name;
    else
      open.pop_back();
  }
  return open.empty() ? "" : open.back();
}

struct ReportHtml : testing::Test {
  void SetUp() override {
    write(folder.path / "a.png", "foobar");
    report.pictures = {{"A picture", "a.png"}};
  }
  std::string html() const { return report_html(report, folder.path); }

  TemporaryFolder folder;
  Report report = made_up_report();
};

TEST_F(ReportHtml, closes_every_tag) {
  EXPECT_EQ(unbalanced_tag("<p><b>x</p></b>"), "/p");
  EXPECT_EQ(unbalanced_tag(html()), "");
  report = {};
  EXPECT_EQ(unbalanced_tag(html()), "");
}

TEST_F(ReportHtml, holds_pictures_and_plots) {
  EXPECT_TRUE(contains(html(), "src=\"data:image/png;base64,Zm9vYmFy\""));
  EXPECT_TRUE(contains(html(), "A picture"));
  EXPECT_TRUE(contains(html(), "<svg"));
  EXPECT_FALSE(contains(html(), "<?xml"));
}

TEST_F(ReportHtml, needs_nothing_from_elsewhere) {
  const std::string page =
      std::regex_replace(html(), std::regex("xmlns(:xlink)?=\"http://www.w3.org/[^\"]*\""), "");
  EXPECT_FALSE(contains(page, "http"));
  EXPECT_FALSE(contains(page, "<script"));
  EXPECT_FALSE(contains(page, "<link"));
  EXPECT_FALSE(contains(page, "@import"));
}

TEST_F(ReportHtml, gives_no_two_elements_the_same_id) {
  const std::string page = html();
  const std::regex id(" id=['\"]([^'\"]*)['\"]");
  std::set<std::string> ids;
  for (std::sregex_iterator i(page.begin(), page.end(), id), end; i != end; ++i)
    EXPECT_TRUE(ids.insert((*i)[1]).second) << (*i)[1];
  EXPECT_FALSE(ids.empty());
}

TEST_F(ReportHtml, escapes_text) {
  report.scene = "a<b&\"c'd";
  report.runs[1].method = "<i>";
  report.left_out = {"<u>"};
  report.pictures[0].first = "\"><s>";
  const std::string page = html();
  EXPECT_TRUE(contains(page, "<h1>a&lt;b&amp;&quot;c&#39;d</h1>"));
  for (const char* raw : {"a<b", "<i>", "<u>", "<s>"}) EXPECT_FALSE(contains(page, raw)) << raw;
  EXPECT_EQ(unbalanced_tag(page), "");
}

TEST_F(ReportHtml, explains_every_column) {
  const std::string page = html();
  for (const char* name : {"threshold", "efficiency", "MRSE", "optimal cut", "certified"})
    EXPECT_TRUE(contains(page, std::string("<dt>") + name + " <span>")) << name;
}

TEST_F(ReportHtml, says_which_picture_it_could_not_read) {
  report.pictures.push_back({"Another", "lost.png"});
  EXPECT_TRUE(contains(html(), "cannot read lost.png"));
}

TEST_F(ReportHtml, is_made_without_gnuplot) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const std::string page = html();
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(contains(page, "the program gnuplot, which draws the plots, is not installed"));
  EXPECT_TRUE(contains(page, "base64,Zm9vYmFy"));
  EXPECT_EQ(unbalanced_tag(page), "");
}

} // namespace
} // namespace lightcuts::oracle
