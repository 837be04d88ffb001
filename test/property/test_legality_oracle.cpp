// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "property/collapse_trials.hpp"

namespace multimesh::test {
namespace {

struct Case {
  std::string name;
  oracle::TreeKind kind;
  bool joint;            // contact = true, host boundary and siblings looked at
  bool cut = false;
};

class LegalityOracle : public testing::TestWithParam<Case> {};

TEST_P(LegalityOracle, X) {
  const Case& c = GetParam();
  TrialCount count;
  std::map<std::string,int> why;
  std::string ex;
  std::map<std::string,int> refusals;
  for (std::uint64_t seed = 0; count.candidates < total_candidates(100000)/20; ++seed) {
    oracle::Tree plain = oracle::random_tree(seed, c.kind, orientable_surface(seed));
    if (c.cut) plain = cut_at_contacts(plain);
    CollapseTrials trials(plain, seed, {.contact = c.joint}, {c.joint, c.joint});
    trials.run([&](const Trial& t) {
      count.add(t);
      EXPECT_EQ(t.fault, "") << trials.describe(t);
      if (t.accepted() && !t.unchanged) { why[t.reason]++; if (ex.empty()) ex = trials.describe(t); }
      if (!t.accepted() && t.unchanged) refusals[std::string(to_string(t.refusal.check))+" node "+std::to_string(index(t.refusal.node))]++;
    });
  }
  std::printf("%s\n%s\n", TrialCount::header().c_str(), count.row(c.name + (c.joint ? " joint" : "")).c_str());
  for (auto& [k, n] : why) std::printf("   %5d %s\n", n, k.c_str());
  for (auto& [k, n] : refusals) std::printf("   harmless %5d %s\n", n, k.c_str());
  if (!ex.empty()) std::printf("  e.g. %s\n", ex.c_str());
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (int k = 0; k < oracle::kNumberOfTreeKinds; ++k)
    for (bool joint : {false, true})
      all.push_back({oracle::to_string(oracle::TreeKind(k)), oracle::TreeKind(k), joint});
  for (bool joint : {false, true}) {
    all.push_back({"curve, cut at contacts", oracle::TreeKind::kCurve, joint, true});
    all.push_back({"two curves, cut at contacts", oracle::TreeKind::kTwoCurves, joint, true});
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Kinds, LegalityOracle, testing::ValuesIn(cases()));

}  // namespace
}  // namespace multimesh::test
