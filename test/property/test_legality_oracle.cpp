// SPDX-License-Identifier: BSD-3-Clause
// Which collapses are accepted, against brute force: every edge of many random trees is tried, and the result
// judged by what identification of vertices makes of every mesh and every image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "property/collapse_trials.hpp"

namespace multimesh::test {
namespace {

/// What an accepted collapse must leave as it was (DESIGN section 7).
enum class Promise {
  /// Every mesh, and every image in all its ancestors: L + U, where a mesh guards each stratum.
  everything,
  /// Every mesh, and every curve in its parent. Seams that no curve lies on are not guarded: a dangling one
  /// may shrink away, and so may what they make of the image of a curve further up.
  meshes_and_curves,
  /// Every mesh. With contacts looked at, the points where a curve meets another child or the boundary are
  /// strata too, and need a cut there; C alone only prevents new contacts.
  meshes
};

bool promised(Promise promise, const oracle::Tree& tree, const oracle::SignaturePart& part) {
  if (promise == Promise::everything || part.host < 0) return true;
  if (promise == Promise::meshes || part.node < 0) return false;
  const oracle::TreeNode& node = tree.nodes[static_cast<std::size_t>(part.node)];
  return node.mesh.dim == 1 && node.parent == part.host;
}

struct Case {
  oracle::TreeKind kind;
  bool joint;  ///< contact = true; the boundary of hosts and contacts of siblings are looked at
  bool cut_at_contacts;
  Promise promise;

  std::string name() const {
    return oracle::to_string(kind) + (cut_at_contacts ? ", cut at contacts" : "") + (joint ? ", joint" : "");
  }
};

constexpr std::array guarded{oracle::TreeKind::kUvRootSeam, oracle::TreeKind::kUvSeam};
constexpr std::array with_bare_seams{oracle::TreeKind::kUv, oracle::TreeKind::kUvPatch,
                                     oracle::TreeKind::kUvOfUv, oracle::TreeKind::kCurveOfUv};

std::vector<Case> cases() {
  const auto is_in = [](const auto& list, oracle::TreeKind k) {
    return std::find(list.begin(), list.end(), k) != list.end();
  };
  std::vector<Case> all;
  for (int i = 0; i < oracle::kNumberOfTreeKinds; ++i) {
    const auto k = static_cast<oracle::TreeKind>(i);
    all.push_back(
        {k, false, false, is_in(with_bare_seams, k) ? Promise::meshes_and_curves : Promise::everything});
    all.push_back({k, true, false, is_in(guarded, k) ? Promise::everything : Promise::meshes});
  }
  for (const auto k : {oracle::TreeKind::kCurve, oracle::TreeKind::kTwoCurves})
    for (const bool joint : {false, true}) all.push_back({k, joint, true, Promise::everything});
  return all;
}

class LegalityOracle : public testing::TestWithParam<Case> {
 protected:
  /// All edges of as many trees as it takes.
  void try_collapses() {
    const Case& c = GetParam();
    const std::size_t wanted = total_candidates(120'000) / cases().size();
    for (std::uint64_t seed = c.joint ? 1'000'000 : 0; count_.candidates < wanted; ++seed) {
      oracle::Tree plain = oracle::random_tree(seed, c.kind, orientable_surface(seed));
      if (c.cut_at_contacts) plain = cut_at_contacts(plain);
      CollapseTrials trials(plain, seed, {.contact = c.joint}, {c.joint, c.joint});
      trials.run([&](const Trial& t) {
        count_.add(t);
        EXPECT_EQ(t.fault, "") << trials.describe(t);
        if (t.accepted()) expect_promise_kept(trials, t);
      });
    }
  }

  void expect_promise_kept(const CollapseTrials& trials, const Trial& t) {
    EXPECT_TRUE(t.valid) << trials.describe(t);
    for (const oracle::SignaturePart& part : t.changed)
      EXPECT_FALSE(promised(GetParam().promise, trials.plain(), part)) << trials.describe(t);
  }

  void report() const {
    std::printf("%s\n%s\n", TrialCount::header().c_str(), count_.row(GetParam().name()).c_str());
    RecordProperty("candidates", static_cast<int>(count_.candidates));
    RecordProperty("accepted", static_cast<int>(count_.accepted));
    RecordProperty("accepted_and_changed", static_cast<int>(count_.changed));
    RecordProperty("refused", static_cast<int>(count_.refused));
    RecordProperty("refused_but_harmless", static_cast<int>(count_.harmless));
  }

  TrialCount count_;
};

// Refused but harmless are, beyond some 0.1 % by U or C: collapses in which two children hold different ends
// of the edge (P). Nothing is glued in either child, but their ends cannot both keep their place.
TEST_P(LegalityOracle, AcceptedCollapsesChangeNothing) {
  try_collapses();
  report();
  EXPECT_EQ(count_.invalid, 0U);
  EXPECT_GT(count_.accepted, count_.candidates / 10) << "nearly everything was refused: the test says little";
  EXPECT_EQ(count_.harmless_refused_by(Check::link_condition), 0U);
  EXPECT_LE(count_.harmless_refused_by(Check::gluing), count_.refused / 200);
  EXPECT_LE(count_.harmless_refused_by(Check::contact), count_.refused / 200);
  EXPECT_LE(count_.harmless, count_.refused / 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LegalityOracle, testing::ValuesIn(cases()), [](const auto& info) {
  std::string name = info.param.name();
  for (std::size_t i = 1; i < name.size(); ++i)
    if (name[i - 1] == ' ') name[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[i])));
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

}  // namespace
}  // namespace multimesh::test
