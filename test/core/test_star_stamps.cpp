// SPDX-License-Identifier: BSD-3-Clause
// What is known to be refused: until a star changes, again after an undone trial, never after a change.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <random>

#include "multimesh/refused_questions.hpp"
#include "multimesh/star_stamps.hpp"

namespace multimesh {
namespace {

TEST(StarStamps, ASimplexHasAnotherOneWhenAnyOfItsStarsChanges) {
  StarStamps stamps;
  const std::array<Index, 2> edge{3, 8}, other{4, 5};
  const auto before = stamps.latest(edge), other_before = stamps.latest(other);
  stamps.change(std::array<Index, 3>{8, 1, 8});
  EXPECT_NE(stamps.latest(edge), before);
  EXPECT_EQ(stamps.latest(other), other_before);
  EXPECT_EQ(stamps.latest(edge), stamps.now());
}

// Against a model that gives every state of every star a name of its own.
TEST(StarStamps, AreEqualExactlyIfTheStarsAreThroughNestedTrials) {
  std::mt19937 random(7);
  StarStamps stamps;
  constexpr Index n = 12;
  std::vector<int> names(n, 0);
  int last = 0;
  std::map<std::pair<Index, StarStamps::Stamp>, int> seen;
  const auto compare = [&] {
    for (Index v = 0; v < n; ++v) {
      const auto [known, is_new] = seen.try_emplace({v, stamps.of(v)}, names[v]);
      ASSERT_TRUE(is_new || known->second == names[v]) << "vertex " << v;
    }
  };
  const std::function<void(int)> act = [&](int depth) {
    for (int i = 0; i < 20; ++i) {
      std::vector<Index> changed(random() % 4);
      for (Index& v : changed) names[v = static_cast<Index>(random() % n)] = ++last;
      stamps.change(changed);
      compare();
      if (depth == 0 || random() % 4 != 0) continue;
      const std::vector<int> names_before = names;
      std::vector<StarStamps::Stamp> before;
      for (Index v = 0; v < n; ++v) before.push_back(stamps.of(v));
      {
        StarStamps::Trial trial(stamps);
        act(depth - 1);
        if (random() % 2) {
          trial.keep();
          continue;
        }
      }
      names = names_before;
      for (Index v = 0; v < n; ++v) ASSERT_EQ(stamps.of(v), before[v]);
    }
  };
  act(3);
}

TEST(RefusedQuestions, AreKnownOnlyUnderTheStampOfTheirRefusal) {
  RefusedQuestions refused(100);
  EXPECT_FALSE(refused.knows(0, 0));
  refused.note(0, 0);
  refused.note(1, 4);
  EXPECT_TRUE(refused.knows(0, 0));
  EXPECT_TRUE(refused.knows(1, 4));
  EXPECT_FALSE(refused.knows(1, 5));
  EXPECT_FALSE(refused.knows(2, 4));
  refused.forget();
  EXPECT_FALSE(refused.knows(1, 4));
}

}  // namespace
}  // namespace multimesh
