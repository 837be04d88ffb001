// SPDX-License-Identifier: BSD-3-Clause
// Each algorithm for surfaces in each domain: the same call, and everything else in the tree follows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/subdivide.hpp"
#include "multimesh/strata.hpp"
#include "test/pairs/domains.hpp"

namespace multimesh::test {
namespace {

class Pairs : public testing::TestWithParam<DomainCase> {
 protected:
  std::unique_ptr<SurfaceInDomain> domain_ = GetParam().make();
  TreeFacts before_ = facts_of(domain_->tree());
  double area_ = domain_->area();

  const Mesh& mesh() const { return domain_->tree().mesh(domain_->surface()); }
  double tolerance() const { return (GetParam().loose_corners ? 0.02 : 1e-9) * area_; }
  double mean_edge() const {
    double sum = 0;
    std::size_t n = 0;
    for (Index e = 0; e < mesh().capacity(1); ++e)
      if (mesh().is_live(1, e)) {
        const Dart d = mesh().dart_of(1, e);
        sum += (domain_->place(d) - domain_->place(mesh().reorder(d, exchange_ends))).norm(), ++n;
      }
    return sum / double(n);
  }
};

TEST_P(Pairs, RemeshReachesTheLength) {
  for (const double share : {0.6, 1.5}) {
    domain_ = GetParam().make();
    RemeshOptions options;
    options.length = share * mean_edge();
    options.iterations = 5;
    const RemeshResult r = remesh(domain_->embedding(), domain_->surface(), options);
    EXPECT_EQ(fault_of(*domain_, before_), "") << share;
    EXPECT_NEAR(domain_->area(), area_, tolerance());
    EXPECT_GT(r.moves, 0U);
    EXPECT_GT(double(r.edges_in_range), (GetParam().in_tets ? 0.6 : 0.75) * double(r.edges)) << share;
  }
}

TEST_P(Pairs, SubdivideMakesFourOfEachTriangle) {
  for (const Subdivision scheme : {Subdivision::midpoint, Subdivision::loop}) {
    domain_ = GetParam().make();
    const std::size_t faces = live_facets(mesh());
    const SubdivideResult r = subdivide(domain_->embedding(), domain_->surface(), {scheme});
    EXPECT_EQ(fault_of(*domain_, before_), "");
    EXPECT_EQ(live_facets(mesh()), 4 * faces);
    EXPECT_EQ(r.refused_splits + r.refused_swaps, 0U);
    EXPECT_NEAR(domain_->area(), area_, tolerance());
  }
}

TEST_P(Pairs, DecimateReachesTheCount) {
  DecimateOptions options;
  options.faces = live_facets(mesh()) * 2 / 5;
  const DecimateResult r = decimate(domain_->embedding(), domain_->surface(), options);
  EXPECT_EQ(fault_of(*domain_, before_), "");
  EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
  EXPECT_EQ(r.faces_after, live_facets(mesh()));
  EXPECT_NEAR(domain_->area(), area_, tolerance());
}

// Told of the root, and asked of the surface wherever it is.
TEST_P(Pairs, DecimateLeavesEdgesThatAnInvariantKeeps) {
  const MultiMesh& tree = domain_->tree();
  const auto ends = [](const Mesh& in, Dart e) {
    const Index a = in.vertex(e), b = in.vertex(in.reorder(e, exchange_ends));
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto places = [&] {
    std::multiset<std::array<Vec3, 2>> all;
    for (Index e = 0; e < mesh().capacity(1); ++e) {
      if (!mesh().is_live(1, e)) continue;
      const Dart d = mesh().dart_of(1, e);
      std::array<Vec3, 2> p{domain_->place(d), domain_->place(mesh().reorder(d, exchange_ends))};
      std::ranges::sort(p);
      all.insert(p);
    }
    return all;
  };
  std::set<std::pair<Index, Index>> kept;
  for (Index e = 0; e < mesh().capacity(1); e += 29)
    kept.insert(ends(tree.mesh(NodeId::root), tree.to_root(domain_->surface(), mesh().dart_of(1, e))));
  Embedding embedding = domain_->embedding();
  embedding.tell_kept_edges(NodeId::root,
                            [&](Dart e) { return kept.contains(ends(tree.mesh(NodeId::root), e)); });
  const Strata strata(embedding, domain_->surface());
  std::multiset<std::array<Vec3, 2>> before;
  for (Index e = 0; e < mesh().capacity(1); ++e) {
    const Dart d = mesh().dart_of(1, e);
    if (!strata.is_kept(d)) continue;
    std::array<Vec3, 2> p{domain_->place(d), domain_->place(mesh().reorder(d, exchange_ends))};
    std::ranges::sort(p);
    before.insert(p);
  }
  EXPECT_GE(before.size(), kept.size());
  DecimateOptions options;
  options.faces = 1;
  EXPECT_GT(decimate(embedding, domain_->surface(), options).collapsed, 10U);
  const auto after = places();
  EXPECT_TRUE(std::ranges::includes(after, before));
}

INSTANTIATE_TEST_SUITE_P(All, Pairs, testing::ValuesIn(domain_cases()),
                         [](const auto& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace multimesh::test
