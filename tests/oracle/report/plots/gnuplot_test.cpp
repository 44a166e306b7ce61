// SPDX-License-Identifier: MIT
#include <oracle/report/plots/gnuplot.h>

#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>
#include <tests/oracle/support/contains.h>

namespace lightcuts::oracle {
namespace {

std::string message_of(const std::string& script) {
  try {
    return gnuplot_svg(script).substr(0, 0);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Gnuplot, draws_data_that_the_script_brings_along) {
  const std::string svg = gnuplot_svg("$data << EOD\n1 2\n3 4\nEOD\nplot $data with lines");
  EXPECT_TRUE(contains(svg, "<svg") && contains(svg, "</svg>"));
}

TEST(Gnuplot, throws_with_its_message_on_a_bad_script) {
  const std::string message = message_of("plot bogus_function(x)");
  EXPECT_TRUE(contains(message, "undefined function: bogus_function")) << message;
  EXPECT_TRUE(contains(message_of("set nonsense"), "line")) << message_of("set nonsense");
}

TEST(Gnuplot, throws_where_nothing_is_drawn) { EXPECT_NE(message_of("x = 1"), ""); }

TEST(Gnuplot, names_the_program_where_it_is_missing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const std::string message = message_of("plot x");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(contains(message, "gnuplot") && contains(message, "not installed")) << message;
}

TEST(Gnuplot, takes_quoted_text_as_it_is) {
  const std::string text = "it's @x `echo no` {/Bold b} \\n $data \"q\"\n";
  const std::string svg = gnuplot_svg("plot x title " + gnuplot_quoted(text) + " noenhanced");
  EXPECT_TRUE(contains(svg, "it's @x `echo no` {/Bold b} \\n $data &quot;q&quot;") ||
              contains(svg, "it's @x `echo no` {/Bold b} \\n $data \"q\""))
      << svg;
}

} // namespace
} // namespace lightcuts::oracle
