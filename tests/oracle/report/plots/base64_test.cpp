// SPDX-License-Identifier: MIT
#include <oracle/report/plots/base64.h>

#include <gtest/gtest.h>

namespace lightcuts::oracle {
namespace {

TEST(Base64, encodes_the_test_vectors_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, encodes_bytes_with_the_high_bit_and_zeros) {
  EXPECT_EQ(base64(std::string_view("\xff\xfe\x00\xfb", 4)), "//4A+w==");
}

} // namespace
} // namespace lightcuts::oracle
