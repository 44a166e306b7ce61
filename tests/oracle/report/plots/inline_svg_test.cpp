// SPDX-License-Identifier: MIT
#include <oracle/report/plots/inline_svg.h>

#include <gtest/gtest.h>

namespace lightcuts::oracle {
namespace {

TEST(InlineSvg, drops_header_title_and_description) {
  EXPECT_EQ(inline_svg("<?xml version=\"1.0\"?>\n<!DOCTYPE svg><svg w='1'><title>t</title>"
                       "<desc>d</desc><g/></svg>",
                       "p-"),
            "<svg w='1'><g/></svg>");
}

TEST(InlineSvg, puts_the_prefix_before_ids_and_references) {
  EXPECT_EQ(inline_svg("<svg><g id='a'/><g id=\"b\"/><use href='#a'/><use xlink:href=\"#b\"/>"
                       "<g filter='url(#a)'/></svg>",
                       "p-"),
            "<svg><g id='p-a'/><g id=\"p-b\"/><use href='#p-a'/><use xlink:href=\"#p-b\"/>"
            "<g filter='url(#p-a)'/></svg>");
}

TEST(InlineSvg, is_empty_without_a_drawing) { EXPECT_EQ(inline_svg("text", "p-"), ""); }

} // namespace
} // namespace lightcuts::oracle
