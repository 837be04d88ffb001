// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "multimesh/pair_numbers.hpp"

namespace multimesh::test {
namespace {

TEST(PairNumbers, CountUpInOrderOfFirstAppearanceAndTakeBothDirections) {
  PairNumbers number(4);
  EXPECT_EQ(number(2, 3), 0U);
  EXPECT_EQ(number(0, 3), 1U);
  EXPECT_EQ(number(3, 2), 0U);
  EXPECT_EQ(number(1, 1), 2U);
  EXPECT_EQ(number(1, 1), 2U);
  EXPECT_EQ(number.size(), 3U);
}

TEST(PairNumbers, AreThoseOfAMapWhateverIsExpected) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const auto indices = static_cast<Index>(1 + random() % 30);
    PairNumbers number(indices);
    for (std::size_t e = random() % 60; e > 0; --e) number.expect(static_cast<Index>(random() % indices));
    std::map<std::pair<Index, Index>, Index> known;
    for (int j = 0; j < 300; ++j) {
      const auto v = static_cast<Index>(random() % indices), w = static_cast<Index>(random() % indices);
      const auto next = static_cast<Index>(known.size());
      EXPECT_EQ(number(v, w), known.try_emplace(std::minmax(v, w), next).first->second);
    }
    EXPECT_EQ(number.size(), known.size());
  }
}

}  // namespace
}  // namespace multimesh::test
