// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tools/base64.hpp"

namespace multimesh::tools {
namespace {

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByte) {
  using namespace std::string_view_literals;
  EXPECT_EQ(base64("\0\0\0"sv), "AAAA");
  EXPECT_EQ(base64("\xff\xff\xff"sv), "////");
  EXPECT_EQ(base64("\xfb\xf0"sv), "+/A=");
}

}  // namespace
}  // namespace multimesh::tools
