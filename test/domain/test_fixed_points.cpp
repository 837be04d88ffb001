// SPDX-License-Identifier: BSD-3-Clause
// The points of a domain that must keep their place: a mesh of dimension 0 with tags and flags.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/strata.hpp"
#include "multimesh/validate.hpp"
#include "test/domain/box.hpp"

namespace multimesh::test {
namespace {

using Place = std::array<double, 3>;

/// Inside, on a face, on an edge and at a corner of a box.
TaggedTetrahedra box_with_points() {
  TaggedTetrahedra in = box(3, 3, 3);
  in.fixed = {point_of(in, 1, 1, 2), point_of(in, 0, 2, 1), point_of(in, 1, 0, 0), point_of(in, 3, 3, 3)};
  in.fixed_tags = {7, 8, 7, 9};
  in.fixed_flags = {0, required_simplex, feature_simplex, feature_simplex | required_simplex};
  return in;
}

/// Tags and flags of the fixed points, by their places in the root.
std::map<Place, std::array<int, 2>> fixed_points(const TetDomain& d) {
  std::map<Place, std::array<int, 2>> all;
  const Mesh& points = d.tree().mesh(*d.fixed_points());
  for (Index p = 0; p < points.capacity(0); ++p) {
    if (!points.is_live(0, p)) continue;
    const Index v = d.mesh().vertex(d.tree().to_parent(*d.fixed_points(), points.dart_of(0, p)));
    const TetDomain::Point& at = d.points()[v];
    all[{at[0], at[1], at[2]}] = {d.fixed_tag(p), d.flags(0, p)};
  }
  return all;
}
std::map<Place, std::array<int, 2>> listed_points(const TaggedTetrahedra& t) {
  std::map<Place, std::array<int, 2>> all;
  for (std::size_t i = 0; i < t.fixed.size(); ++i)
    all[t.points[t.fixed[i]]] = {t.fixed_tags[i], t.fixed_flags[i]};
  return all;
}

TEST(FixedPoints, AreAMeshOfDimensionZeroWithTagsAndFlags) {
  const TaggedTetrahedra in = box_with_points();
  const TetDomain d(in);
  ASSERT_TRUE(d.fixed_points());
  EXPECT_EQ(d.tree().mesh(*d.fixed_points()).dimension(), 0);
  EXPECT_EQ(validate(d.tree()), std::vector<std::string>{});
  EXPECT_EQ(fixed_points(d), listed_points(in));
  EXPECT_EQ(listed_points(d.tagged()), listed_points(in));
  EXPECT_EQ(report(d).fixed_tags, (std::map<TetDomain::Tag, std::size_t>{{7, 2}, {8, 1}, {9, 1}}));
  EXPECT_FALSE(TetDomain(box(1, 1, 1)).fixed_points());
}

TEST(FixedPoints, NeedNoLock) {
  const TetDomain d(box_with_points());
  for (Index v = 0; v < d.mesh().capacity(0); ++v) EXPECT_FALSE(d.mesh().is_locked(v));
}

// Whoever smooths the surface has to know which vertices stay.
TEST(FixedPoints, OfASurfaceAreNotFree) {
  const TaggedTetrahedra in = box_with_points();
  const TetDomain d(in);
  Strata strata(d.tree(), *d.surface());
  const Mesh& surface = d.tree().mesh(*d.surface());
  std::size_t held = 0;
  for (Index v = 0; v < surface.capacity(0); ++v) {
    const Dart at = surface.dart_of(0, v);
    const bool is_fixed =
        d.tree().has_preimage(NodeId::root, d.tree().to_root(*d.surface(), at), 0, *d.fixed_points());
    EXPECT_EQ(strata.freedom(at), is_fixed ? Freedom::none : Freedom::surface);
    held += is_fixed;
  }
  EXPECT_EQ(held, 3U);
}

TEST(FixedPoints, StayWhereTheyAreInStormsAndCompactions) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const TaggedTetrahedra in = box_with_points();
    TetDomain d(in, {.feature_angle = seed % 2 ? 0.5 : 10});
    const Embedding embedding = d.embedding();
    EmbeddedMesh root(embedding, NodeId::root);
    std::mt19937 random(seed);
    std::size_t done = 0;
    for (int i = 0; i < 600; ++i) {
      Index t;
      do t = static_cast<Index>(random() % d.mesh().capacity(3));
      while (!d.mesh().is_live(3, t));
      const Dart e = tet::TetMesh::dart(t, {static_cast<std::uint8_t>(random() % 24)});
      const auto choice = random() % 6;
      done += choice == 0   ? bool(root.operations().split(NodeId::root, e))
              : choice == 1 ? bool(root.operations().swap_face(NodeId::root, e))
              : choice == 2 ? bool(root.operations().swap(NodeId::root, e))
                            : bool(root.operations().collapse(NodeId::root, e));
      if (i % 200 == 199) d.tree().compact();
    }
    EXPECT_GT(done, 60U);
    EXPECT_EQ(validate(d.tree()), std::vector<std::string>{});
    EXPECT_EQ(fixed_points(d), listed_points(in)) << "seed " << seed;
    EXPECT_EQ(listed_points(d.tagged()), listed_points(in)) << "seed " << seed;
  }
}

TEST(FixedPoints, ThatAreRequiredCannotBeMoved) {
  TetDomain d(box_with_points());
  const Embedding embedding = d.embedding();
  EmbeddedMesh root(embedding, NodeId::root);
  const Mesh& points = d.tree().mesh(*d.fixed_points());
  for (Index p = 0; p < points.capacity(0); ++p) {
    const Outcome o =
        root.operations().relocate(*d.fixed_points(), points.dart_of(0, p), [](const Event&) {});
    EXPECT_EQ(bool(o), (d.flags(0, p) & required_simplex) == 0);
  }
}

}  // namespace
}  // namespace multimesh::test
