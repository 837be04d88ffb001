// SPDX-License-Identifier: BSD-3-Clause
// Which collapses are accepted, against brute force: every edge of many random trees is tried, and judged by
// the effect of identifying vertices on every mesh and every image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <functional>

#include "oracle/random_solid_trees.hpp"
#include "property/collapse_trials.hpp"

namespace multimesh::test {
namespace {

/// What an accepted collapse must leave as it was (docs/concepts.md#when-a-collapse-is-legal).
enum class Promise {
  /// Every mesh, and every image in all its ancestors: L + U, where a mesh guards each stratum.
  everything,
  /// Every mesh, and every curve in its parent. Seams that no curve lies on are not guarded: a dangling one
  /// may shrink away, and so may what they make of the image of a curve further up.
  meshes_and_curves,
  /// Every mesh, and in dimension 3 the homotopy type of every image and of what is left of its ancestors
  /// without it: L + U. The edges and points at which an image is no surface need a guard.
  homotopy,
  /// As homotopy, also of what children of one mesh have in common with one another and with its boundary: C,
  /// which does not look at grandchildren.
  homotopy_of_children,
  /// Every mesh. With contacts looked at, the points where a curve meets another child or the boundary are
  /// strata too, and need a cut there; C alone only prevents new contacts.
  meshes
};

int dimension(const oracle::Tree& tree, int node) {
  return tree.nodes[static_cast<std::size_t>(node)].mesh.dim;
}

bool promised(Promise promise, const oracle::Tree& tree, const oracle::SignaturePart& part) {
  if (promise == Promise::everything || part.host < 0) return true;
  if (promise == Promise::meshes) return false;
  if (promise == Promise::homotopy_of_children && part.node >= 0 &&
      tree.nodes[static_cast<std::size_t>(part.node)].parent != part.host)
    return false;
  if (promise == Promise::homotopy || promise == Promise::homotopy_of_children)
    return dimension(tree, part.host) == 3 && part.aspect != oracle::SignaturePart::Aspect::kGraph;
  if (part.node < 0) return false;
  return dimension(tree, part.node) <= 1 &&
         tree.nodes[static_cast<std::size_t>(part.node)].parent == part.host;
}

struct Case {
  std::string name;
  std::function<oracle::Tree(std::uint64_t seed)> make;
  bool joint;  ///< contact = true; the boundary of hosts and contacts of siblings are looked at
  Promise promise;
  bool in_solid = false;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

constexpr std::array guarded{oracle::TreeKind::kUvRootSeam, oracle::TreeKind::kUvSeam,
                             oracle::TreeKind::kPoints};
constexpr std::array with_bare_seams{oracle::TreeKind::kUv, oracle::TreeKind::kUvPatch,
                                     oracle::TreeKind::kUvOfUv, oracle::TreeKind::kCurveOfUv,
                                     oracle::TreeKind::kPointsOfUv};

Case surface_case(oracle::TreeKind kind, bool joint, bool at_contacts, Promise promise) {
  const auto make = [=](std::uint64_t seed) {
    const oracle::Tree plain = oracle::random_tree(seed, kind, orientable_surface(seed));
    return at_contacts ? cut_at_contacts(plain) : plain;
  };
  return {oracle::to_string(kind) + (at_contacts ? ", cut at contacts" : "") + (joint ? ", joint" : ""), make,
          joint, promise};
}

Case solid_case(oracle::SolidTreeKind kind, bool joint, Promise promise) {
  const auto make = [=](std::uint64_t seed) {
    return oracle::random_solid_tree(seed, kind, static_cast<oracle::Solid>(seed % 4));  // not the 3-torus
  };
  return {oracle::to_string(kind) + (joint ? ", joint" : ""), make, joint, promise, true};
}

std::vector<Case> cases() {
  const auto is_in = [](const auto& list, oracle::TreeKind k) {
    return std::find(list.begin(), list.end(), k) != list.end();
  };
  std::vector<Case> all;
  for (int i = 0; i < oracle::kNumberOfTreeKinds; ++i) {
    const auto k = static_cast<oracle::TreeKind>(i);
    all.push_back(surface_case(k, false, false,
                               is_in(with_bare_seams, k) ? Promise::meshes_and_curves : Promise::everything));
    all.push_back(surface_case(k, true, false, is_in(guarded, k) ? Promise::everything : Promise::meshes));
  }
  for (const auto k : {oracle::TreeKind::kCurve, oracle::TreeKind::kTwoCurves})
    for (const bool joint : {false, true}) all.push_back(surface_case(k, joint, true, Promise::everything));
  for (int i = 0; i < oracle::kNumberOfSolidTreeKinds; ++i) {
    const auto k = static_cast<oracle::SolidTreeKind>(i);
    const bool everything = k == oracle::SolidTreeKind::kSurfaceGuarded ||
                            k == oracle::SolidTreeKind::kSurfacesGuarded ||
                            k == oracle::SolidTreeKind::kCurve || k == oracle::SolidTreeKind::kBoundary ||
                            k == oracle::SolidTreeKind::kPoints;
    all.push_back(solid_case(k, false, everything ? Promise::everything : Promise::homotopy));
    const bool joint_guard = k == oracle::SolidTreeKind::kSurfaceGuarded ||
                             k == oracle::SolidTreeKind::kSurfacesGuarded ||
                             k == oracle::SolidTreeKind::kPoints;
    all.push_back(solid_case(k, true, joint_guard ? Promise::everything : Promise::homotopy_of_children));
  }
  return all;
}

class LegalityOracle : public testing::TestWithParam<Case> {
 protected:
  /// All edges of as many trees as it takes.
  void try_collapses() {
    const Case& c = GetParam();
    const std::size_t each = total_candidates(120'000) / 24;
    const std::size_t wanted = c.in_solid ? each / 5 : each;  // trials in dimension 3 take longer
    for (std::uint64_t seed = c.joint ? 1'000'000 : 0; count_.candidates < wanted; ++seed) {
      CollapseTrials trials(c.make(seed), seed, {.contact = c.joint}, {c.joint, c.joint});
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
    std::printf("%s\n%s\n", TrialCount::header().c_str(), count_.row(GetParam().name).c_str());
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
  const bool in_solid = GetParam().in_solid;
  EXPECT_GT(count_.accepted, count_.candidates / (in_solid ? 20 : 10))
      << "nearly everything was refused: the test says little";
  if (in_solid) {  // L is local: another homeomorphism may exist, in small meshes above all
    EXPECT_LE(count_.harmless_refused_by(Check::link_condition), count_.refused / 10);
  } else {
    EXPECT_EQ(count_.harmless_refused_by(Check::link_condition), 0U);
  }
  EXPECT_LE(count_.harmless_refused_by(Check::gluing), count_.refused / (in_solid ? 50 : 200));
  EXPECT_LE(count_.harmless_refused_by(Check::contact), count_.refused / (in_solid ? 20 : 200));
  EXPECT_LE(count_.harmless, count_.refused / (in_solid ? 5 : 10));
}

INSTANTIATE_TEST_SUITE_P(Kinds, LegalityOracle, testing::ValuesIn(cases()), [](const auto& info) {
  std::string name = info.param.name;
  for (std::size_t i = 1; i < name.size(); ++i)
    if (name[i - 1] == ' ') name[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[i])));
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

}  // namespace
}  // namespace multimesh::test
