// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "multimesh/algorithms/improvement/refusals.hpp"

namespace multimesh::improvement {
namespace {

TEST(Refusals, HoldUntilTheStarChanges) {
  Refusals refusals(100);
  refusals.change({1, 2, 3}, true);
  EXPECT_FALSE(refusals.knows(Kind::collapse, 1, 2));
  refusals.note(Kind::collapse, 1, 2);
  EXPECT_TRUE(refusals.knows(Kind::collapse, 1, 2));
  EXPECT_FALSE(refusals.knows(Kind::collapse, 2, 1));
  EXPECT_FALSE(refusals.knows(Kind::split, 1, 2));
  refusals.change({2}, false);
  EXPECT_TRUE(refusals.knows(Kind::collapse, 1, 2));
  refusals.change({1}, false);
  EXPECT_FALSE(refusals.knows(Kind::collapse, 1, 2));
  refusals.note(Kind::collapse, 1, 2);
  refusals.forget();
  EXPECT_FALSE(refusals.knows(Kind::collapse, 1, 2));
}

TEST(Refusals, OfAnUndoneTrialDoNotHoldAndThoseBeforeItDo) {
  Refusals refusals(100);
  refusals.change({1, 2}, true);
  refusals.note(Kind::smoothing, 1, 1);
  {
    Refusals::Trial outer(refusals);
    refusals.change({1, 7}, true);
    refusals.note(Kind::smoothing, 7, 7);
    {
      Refusals::Trial inner(refusals);
      refusals.change({1, 2}, true);
      refusals.note(Kind::smoothing, 2, 2);
      inner.keep();
    }
    EXPECT_TRUE(refusals.knows(Kind::smoothing, 2, 2));
  }
  EXPECT_TRUE(refusals.knows(Kind::smoothing, 1, 1));
  EXPECT_FALSE(refusals.knows(Kind::smoothing, 2, 2));
  EXPECT_FALSE(refusals.knows(Kind::smoothing, 7, 7));
}

TEST(Refusals, OfHeldVerticesOutlastWhatHappensInside) {
  Refusals refusals(100);
  refusals.change({1, 2}, true);
  EXPECT_FALSE(refusals.knows_held(1));
  refusals.note_held(1);
  refusals.change({1, 2}, false);
  EXPECT_TRUE(refusals.knows_held(1));
  refusals.change({1, 2}, true);
  EXPECT_FALSE(refusals.knows_held(1));
}

}  // namespace
}  // namespace multimesh::improvement
