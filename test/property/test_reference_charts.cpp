// SPDX-License-Identifier: BSD-3-Clause
// As test_reference_faults.cpp: faults of the reference implementation that concern charts.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/validate.hpp"
#include "property/collapse_trials.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

// --- a mirrored chart never collapses
// -----------------------------------------------------------------------

/// Number of facets over which the child has the opposite orientation.
std::size_t mirrored_facets(const oracle::Tree& tree) {
  const oracle::TreeNode& child = tree.nodes[1];
  std::size_t mirrored = 0;
  for (const auto& f : child.mesh.facets)
    for (const auto& g : tree.nodes[0].mesh.facets)
      for (std::size_t i = 0; i < 3; ++i)
        mirrored += child.image.at(f[0]) == g[i] && child.image.at(f[1]) == g[(i + 2) % 3] &&
                    child.image.at(f[2]) == g[(i + 1) % 3];
  return mirrored;
}

TEST(ReferenceFaults, AMirroredChartCollapsesAsAnyOther) {
  std::size_t mirrored = 0, upright = 0, accepted = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto kind = seed % 2 ? oracle::TreeKind::kUv : oracle::TreeKind::kUvPatch;
    const oracle::Tree plain = oracle::random_tree(seed, kind, orientable_surface(seed));
    std::vector<Check> verdicts;
    for (std::uint64_t orientation = 0; orientation < 4; ++orientation) {
      std::mt19937_64 rng(orientation);
      auto tree = to_multimesh(plain, rng);
      ASSERT_TRUE(tree);
      const std::size_t here = mirrored_facets(to_oracle(*tree));
      mirrored += here, upright += to_oracle(*tree).nodes[1].mesh.facets.size() - here;
      const Mesh& root = tree->mesh(NodeId::root);
      Propagation ops(*tree);
      std::vector<Check> now;
      for (Index e = 0; e < root.capacity(1); ++e) {
        now.push_back(ops.judge(NodeId::root, root.dart_of(1, e)).refusal.check);
        const Transaction undone(*tree, {});
        accepted += bool(ops.collapse(NodeId::root, root.dart_of(1, e)));
        ASSERT_TRUE(validate(*tree).empty()) << "seed " << seed;
      }
      if (verdicts.empty()) verdicts = now;
      EXPECT_EQ(now, verdicts) << "seed " << seed << " orientation " << orientation;
    }
  }
  EXPECT_GT(mirrored, upright / 4);
  EXPECT_GT(upright, mirrored / 4);
  EXPECT_GT(accepted, 0U);
}

// --- position and UV of a new vertex are different points of the surface
// ------------------------------------

/// In each chart, a fixed affine map takes positions to (u, v, chart); every third chart is mirrored.
/// Whatever happens, UVs must stay the images of positions.
class AffineCharts {
 public:
  AffineCharts(Tree& tree, NodeId uv) : tree_(tree), uv_(uv), mesh_(tree.tree->mesh(uv)) {
    auto& om = dynamic_cast<openmesh::Connectivity&>(tree.tree->mesh(uv)).openmesh();
    OpenMesh::VPropHandleT<Point3> property;
    om.add_property(property, "test:uv");
    values_ = &om.property(property).data_vector();
    number_charts();
    attribute_.emplace(uv, *values_);
    tree.operations->add(*attribute_);
  }

  std::string fault() const {
    for (Index v = 0; v < mesh_.capacity(0); ++v) {
      if (!mesh_.is_live(0, v)) continue;
      const Point3 uv = (*values_)[v];
      const double chart = std::round(uv[2]);
      if ((uv - uv_at(chart, v)).norm() > 1e-9)
        return "UV and position of vertex " + std::to_string(v) + " came apart";
    }
    return {};
  }

 private:
  Point3 uv_at(double chart, Index v) const {
    const Dart above = tree_.tree->to_root(uv_, mesh_.dart_of(0, v));
    const Point3 p = tree_.points(NodeId::root)[tree_.tree->mesh(NodeId::root).vertex(above)];
    const double mirror = std::fmod(chart, 3.0) == 0 ? -1 : 1;
    return {mirror * (2 * p[0] + p[2]) + 7 * chart, p[1] - 0.5 * p[0] - chart, chart};
  }

  void number_charts() {
    std::vector<bool> known(mesh_.capacity(0), false);
    DartBuffer queue, star;
    double chart = 0;
    for (Index start = 0; start < mesh_.capacity(0); ++start) {
      if (known[start]) continue;
      queue.assign(1, mesh_.dart_of(0, start));
      known[start] = true;
      for (std::size_t q = 0; q < queue.size(); ++q) {
        (*values_)[mesh_.vertex(queue[q])] = uv_at(chart, mesh_.vertex(queue[q]));
        mesh_.star(queue[q], 0, star);
        for (const Dart d : star)
          for (const Permutation p :
               {edge_ax, edge_bx, permutation(2, 0, 1), permutation(2, 1, 0), exchange_ends}) {
            const Dart other = mesh_.reorder(d, p);
            if (known[mesh_.vertex(other)]) continue;
            known[mesh_.vertex(other)] = true;
            queue.push_back(other);
          }
      }
      chart += 1;
    }
  }

  Tree& tree_;
  NodeId uv_;
  const Mesh& mesh_;
  std::vector<Point3>* values_ = nullptr;
  std::optional<VertexAttribute<Point3>> attribute_;
};

TEST(ReferenceFaults, PositionsAndUvsOfNewVerticesAreTheSamePoint) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Tree tree(seed % 2 ? grid(4, 4) : annulus(5, 3));
    std::mt19937_64 rng(seed);
    std::vector<bool> seams(tree.tree->mesh(NodeId::root).capacity(1));
    for (std::size_t e = 0; e < seams.size(); ++e) seams[e] = oracle::chance(rng, 40);
    const NodeId uv = tree.add_cut(NodeId::root, [&](Index e) { return seams[e]; });
    AffineCharts charts(tree, uv);
    ASSERT_EQ(charts.fault(), "");
    // Splits at any place, collapses to any place and swaps; not the storm's own moves of vertices.
    for (int i = 0; i < 200; ++i) {
      const NodeId n = oracle::chance(rng, 50) ? NodeId::root : uv;
      const Mesh& mesh = tree.tree->mesh(n);
      const auto f = static_cast<Index>(oracle::pick(rng, mesh.capacity(2)));
      if (!mesh.is_live(2, f)) continue;
      const Dart d = mesh.reorder(mesh.dart_of(2, f), {static_cast<std::uint8_t>(oracle::pick(rng, 6))});
      const double t = 0.125 * static_cast<double>(oracle::pick(rng, 9));
      const std::size_t choice = oracle::pick(rng, 100);
      const Outcome outcome = choice < 25   ? tree.operations->split(n, d, 0.125 + 0.75 * t)
                              : choice < 80 ? tree.operations->collapse(n, d, Placement::at(t))
                                            : tree.operations->swap(n, d);
      ASSERT_EQ(outcome ? charts.fault() : "", "") << "operation " << i;
    }
    EXPECT_GT(tree.operations->statistics().done, 20U);
  }
}

}  // namespace
}  // namespace multimesh::test
