// SPDX-License-Identifier: BSD-3-Clause
// A second oracle for one curve in a surface: the link condition for substructures on tags (Vivodtzev et al.
// 2010, see oracle/vivodtzev.hpp), which knows no child mesh and no map.
#include <gtest/gtest.h>

#include <cstdio>

#include "oracle/image.hpp"
#include "oracle/vivodtzev.hpp"
#include "property/collapse_trials.hpp"

namespace multimesh::test {
namespace {

enum class Tags { edges, edges_and_ends, edges_and_points };

struct Agreement {
  std::size_t candidates = 0, both_allow = 0, both_refuse = 0;
  std::size_t only_tags_allow = 0, only_we_allow = 0;

  void print(const char* name) const {
    std::printf("%-36s %10s %10s %11s %15s %13s\n%-36s %10zu %10zu %11zu %15zu %13zu\n", "tags against maps",
                "candidates", "both allow", "both refuse", "only tags allow", "only we allow", name,
                candidates, both_allow, both_refuse, only_tags_allow, only_we_allow);
    testing::Test::RecordProperty("candidates", static_cast<int>(candidates));
    testing::Test::RecordProperty("differences", static_cast<int>(only_tags_allow + only_we_allow));
    EXPECT_GT(both_allow, candidates / 10);
    EXPECT_GT(both_refuse, candidates / 10);
  }
};

/// Points of the surface over which a chain of the curve ends.
oracle::SimplexSet ends_of_chains(const oracle::Tree& tree) {
  oracle::SimplexSet points;
  for (const int v : boundary_points(tree.nodes[1].mesh))
    points.push_back(oracle::simplex({tree.nodes[1].image.at(v)}));
  oracle::normalize(points);
  return points;
}

/// All that points of the tree lie over.
oracle::SimplexSet images_of_points(const oracle::Tree& tree) {
  oracle::SimplexSet points;
  for (std::size_t i = 1; i < tree.nodes.size(); ++i)
    if (tree.nodes[i].mesh.dim == 0) points = oracle::unite(points, image(tree, static_cast<int>(i), 0));
  return points;
}

class VivodtzevOracle : public testing::Test {
 protected:
  /// Tries a quarter of all candidates; `disagree(tags_allow, trial, where)` is called for each difference.
  template <class Disagree>
  Agreement compare(bool joint, bool cut, Tags tags, const Disagree& disagree,
                    oracle::TreeKind kind = oracle::TreeKind::kCurve) {
    Agreement count;
    const std::size_t wanted = total_candidates(100'000) / 4;
    const auto strata = joint ? oracle::Strata::kJoint : oracle::Strata::kSeparate;
    const std::uint64_t first = (joint ? 2'000'000U : 0U) + (cut ? 1'000'000U : 0U);
    for (std::uint64_t seed = first; count.candidates < wanted; ++seed) {
      oracle::Tree plain = oracle::random_tree(seed, kind, orientable_surface(seed));
      if (cut) plain = cut_at_contacts(plain);
      CollapseTrials trials(plain, seed, {.contact = joint}, {joint, false});
      const oracle::Tree& tree = trials.plain();
      oracle::TaggedSurface tagged{tree.nodes[0].mesh, of_dimension(image(tree, 1, 0), 1), {}};
      if (tags == Tags::edges_and_ends) tagged.vertices = ends_of_chains(tree);
      if (tags == Tags::edges_and_points) tagged.vertices = images_of_points(tree);
      trials.run([&](const Trial& t) {
        ASSERT_EQ(t.fault, "") << trials.describe(t);
        const bool allowed = substructure_link_condition(tagged, t.edge.v[0], t.edge.v[1], strata);
        ++count.candidates;
        if (allowed == t.accepted()) return void(++(allowed ? count.both_allow : count.both_refuse));
        ++(allowed ? count.only_tags_allow : count.only_we_allow);
        disagree(allowed, t, trials.describe(t));
      });
    }
    return count;
  }
};

const auto none = [](bool, const Trial&, const std::string& where) { ADD_FAILURE() << where; };

// A curve cut at its junctions only. The boundary is another stratum, contacts with it do not count.
TEST_F(VivodtzevOracle, SeparateStrataAllowExactlyWhatWeDo) {
  compare(false, false, Tags::edges, none).print("separate");
}

// The curve is also cut where it meets or leaves the boundary. Tags on edges do not show such ends; they are
// tagged vertices.
TEST_F(VivodtzevOracle, TaggedVerticesAreEndsOfChains) {
  compare(false, true, Tags::edges_and_ends, none).print("separate, cut at contacts");
}

// Meshes of dimension 0: points that must stay points of their own.
TEST_F(VivodtzevOracle, TaggedVerticesArePoints) {
  compare(false, false, Tags::edges_and_points, none, oracle::TreeKind::kPoints).print("points");
}
TEST_F(VivodtzevOracle, TaggedVerticesArePointsAlsoWhereTheBoundaryCounts) {
  compare(true, false, Tags::edges_and_points, none, oracle::TreeKind::kPoints).print("points, joint");
}

// Class of differences: tags also keep a point apart from the end of a chain, both of which are vertices of
// order 2. For us the chain may shrink until it ends at the point. So tags refuse more, and nothing of what
// they refuse more changes the curve or the points.
TEST_F(VivodtzevOracle, TaggedVerticesArePointsBesideAndBelowCurves) {
  const auto classify = [](bool tags_allow, const Trial& t, const std::string& where) {
    EXPECT_FALSE(tags_allow) << where;
    EXPECT_TRUE(t.unchanged()) << where;
  };
  const Agreement count =
      compare(false, false, Tags::edges_and_points, classify, oracle::TreeKind::kPointsOfCurve);
  count.print("points and curves");
  EXPECT_GT(count.only_we_allow, 0U) << "the class is empty: drop it";
  EXPECT_LT(count.only_we_allow, count.candidates / 50);
}

// Class of differences: the joint condition guards the points at which the curve meets or leaves the boundary
// (vertices of order 2). We do so only where a chain ends there (G); C forbids new contacts, not that an old
// one moves along the curve to its end or another contact. So tags refuse more, and all that they refuse more
// changes the graph of curve and boundary and nothing else: they are not more cautious, they guard more.
TEST_F(VivodtzevOracle, JointStrataGuardContactsThatNoChainEndsAt) {
  const auto classify = [](bool tags_allow, const Trial& t, const std::string& where) {
    EXPECT_FALSE(tags_allow) << where;
    EXPECT_TRUE(t.valid) << where;
    ASSERT_EQ(t.changed.size(), 1U) << where;
    EXPECT_EQ(t.changed[0].aspect, oracle::SignaturePart::Aspect::kGraph) << where;
    EXPECT_EQ(t.changed[0].node, 1) << where;
  };
  const Agreement count = compare(true, false, Tags::edges, classify);
  count.print("joint");
  EXPECT_EQ(count.only_tags_allow, 0U);
  EXPECT_GT(count.only_we_allow, 0U) << "the class is empty: drop it";
  EXPECT_LT(count.only_we_allow, count.candidates / 50);
}

// With that guard there is no difference.
TEST_F(VivodtzevOracle, JointStrataAllowExactlyWhatWeDoWithGuards) {
  compare(true, true, Tags::edges, none).print("joint, cut at contacts");
}

}  // namespace
}  // namespace multimesh::test
