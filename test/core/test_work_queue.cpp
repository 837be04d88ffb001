// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "multimesh/work_queue.hpp"

namespace multimesh {
namespace {

// Costs from a small set, so that ties are common; bursts of pushes, so that all parts of the queue are used.
TEST(WorkQueue, PopsInTheOrderOfAnOrderedSet) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    WorkQueue queue;
    std::map<Index, double> cost;
    std::set<std::pair<double, Index>> expected;
    const auto erase = [&](Index e) {
      if (const auto known = cost.find(e); known != cost.end()) {
        expected.erase({known->second, e});
        cost.erase(known);
      }
    };
    for (int burst = 0; burst < 40; ++burst) {
      for (auto n = random() % 3000; n-- > 0;) {
        const auto e = static_cast<Index>(random() % 20'000);
        erase(e);
        if (random() % 10 == 0) {
          queue.erase(e);
          continue;
        }
        const double c = 0.25 * static_cast<double>(random() % (seed % 2 ? 7 : 5000));
        queue.push(e, c);
        cost[e] = c;
        expected.insert({c, e});
      }
      for (auto n = random() % 2500; n-- > 0;) {
        WorkQueue::Entry least{};
        ASSERT_EQ(queue.pop(least), !expected.empty());
        if (expected.empty()) break;
        ASSERT_EQ(std::pair(least.cost, least.simplex), *expected.begin());
        erase(least.simplex);
      }
    }
  }
}

}  // namespace
}  // namespace multimesh
