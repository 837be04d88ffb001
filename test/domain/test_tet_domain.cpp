// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/error.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"
#include "test/domain/box.hpp"

namespace multimesh::test {
namespace {

using Tag = TaggedTetrahedra::Tag;

Tag left_or_right(Index x, Index, Index) {
  return x < 1 ? 1 : 2;
}

void add_triangle(TaggedTetrahedra& t, std::array<Index, 3> v, Tag tag) {
  t.triangles.corners.insert(t.triangles.corners.end(), v.begin(), v.end());
  t.patches.push_back(tag);
}

/// Corners as sets of coordinates, tags beside: what must survive renumbering.
template <std::size_t n>
auto named(const std::vector<std::array<double, 3>>& points, const std::vector<Index>& corners,
           const std::vector<Tag>& tags) {
  std::multiset<std::pair<std::set<std::array<double, 3>>, Tag>> all;
  for (std::size_t i = 0; i < corners.size() / n; ++i) {
    std::set<std::array<double, 3>> simplex;
    for (std::size_t j = 0; j < n; ++j) simplex.insert(points[corners[n * i + j]]);
    all.emplace(simplex, tags.empty() ? 0 : tags[i]);
  }
  return all;
}

TEST(TetDomain, TakesTheBoundaryAndTheInterfaceAsOneSurface) {
  const TetDomain d(box(2, 2, 2, left_or_right));
  const DomainReport r = report(d);
  EXPECT_EQ(validate(d.tree()), std::vector<std::string>{});
  EXPECT_EQ(r.tets.tets, 48U);
  EXPECT_EQ(r.tets.handles, 0);
  EXPECT_EQ(r.tets.cavities, 0);
  ASSERT_TRUE(r.surface);
  EXPECT_EQ(r.surface->faces, 6 * 8U + 8);
  // Cut where the interface meets the boundary: both halves and the interface are disks.
  EXPECT_EQ(r.surface->components, 3U);
  EXPECT_EQ(r.surface->euler_characteristic, 3);
  ASSERT_TRUE(r.curves);
  EXPECT_EQ(r.curves->edges, 8U);
  EXPECT_EQ(r.curves->components, 1U);
  EXPECT_EQ(r.curves->boundary, 0U) << "a loop";
  EXPECT_EQ(r.inverted_tets, 0U);
  EXPECT_DOUBLE_EQ(r.regions.at(1).volume, 4);
}

TEST(TetDomain, LeavesOutWhatIsNotWanted) {
  const TetDomain nothing(box(2, 1, 1, left_or_right), {.boundary = false, .interfaces = false});
  EXPECT_FALSE(nothing.surface());
  EXPECT_FALSE(nothing.curves());
  const TetDomain interface(box(2, 2, 2, left_or_right), {.boundary = false});
  const DomainReport r = report(interface);
  EXPECT_EQ(r.surface->faces, 8U);
  EXPECT_EQ(r.curves->edges, 8U) << "the rim of the open sheet";
}

TEST(TetDomain, MakesCurvesOfSharpEdges) {
  const TetDomain d(box(2, 2, 2), {.feature_angle = 0.5});
  const DomainReport r = report(d);
  EXPECT_EQ(r.curves->edges, 24U);
  EXPECT_EQ(r.curves->components, 12U) << "chains end at the corners of the box";
  EXPECT_EQ(r.curves->boundary, 24U);
  EXPECT_FALSE(TetDomain(box(2, 2, 2), {.feature_angle = 1.6}).curves()) << "right angles are less than that";
}

TEST(TetDomain, MakesCurvesOfBordersBetweenPatches) {
  TaggedTetrahedra in = box(1, 1, 1);
  const auto p = [&](double x, double y, double z) { return point_of(in, x, y, z); };
  add_triangle(in, {p(0, 0, 0), p(1, 0, 0), p(1, 1, 0)}, 7);
  add_triangle(in, {p(0, 0, 0), p(0, 1, 0), p(1, 1, 0)}, 7);
  const TetDomain d(in);
  const DomainReport r = report(d);
  EXPECT_EQ(r.patches, (std::map<Tag, std::size_t>{{0, 10}, {7, 2}}));
  EXPECT_EQ(r.curves->edges, 4U);
  EXPECT_EQ(r.curves->components, 1U);
  EXPECT_EQ(d.report().missing_triangles, 0U);
}

TEST(TetDomain, KeepsListedEdgesAndTellsWhatIsMissing) {
  TaggedTetrahedra in = box(2, 2, 2);
  const Index low = point_of(in, 1, 1, 0), middle = point_of(in, 1, 1, 1), high = point_of(in, 1, 1, 2);
  in.edges.corners = {low, middle, high, middle, low, high};  // the last one is no edge
  in.edge_tags = {5, 5, 6};
  add_triangle(in, {low, middle, high}, 3);  // no face
  const TetDomain d(in);
  EXPECT_EQ(d.report().missing_edges, 1U);
  EXPECT_EQ(d.report().missing_triangles, 1U);
  const DomainReport r = report(d);
  EXPECT_EQ(r.curve_tags, (std::map<Tag, std::size_t>{{5, 2}}));
  EXPECT_EQ(r.curves->components, 1U);
  // The curve touches the surface at its ends, where nothing but a point can hold it.
  EXPECT_EQ(r.fixed_points, 2U);
}

TEST(TetDomain, EndsCurvesWhereTheirTagChanges) {
  TaggedTetrahedra in = box(2, 2, 2);
  in.edges.corners = {point_of(in, 1, 1, 0), point_of(in, 1, 1, 1), point_of(in, 1, 1, 1),
                      point_of(in, 1, 1, 2)};
  in.edge_tags = {5, 6};
  EXPECT_EQ(report(TetDomain(in)).curves->components, 2U);
}

TEST(TetDomain, OrientsTetrahedraPositively) {
  TaggedTetrahedra in = box(2, 1, 1);
  std::mt19937 random(1);
  std::size_t turned = 0;
  for (std::size_t t = 0; t < in.tets.size(); ++t)
    if (random() % 3 == 0) std::swap(in.tets.corners[4 * t], in.tets.corners[4 * t + 1]), ++turned;
  const TetDomain d(in);
  EXPECT_EQ(d.report().reversed_tets, turned);
  EXPECT_EQ(d.report().inverted_tets, 0U);
  EXPECT_EQ(report(d).inverted_tets, 0U);
}

TEST(TetDomain, TellsInvertedTetrahedra) {
  TaggedTetrahedra in = box(2, 2, 2);
  in.points[point_of(in, 1, 1, 1)] = {1, 1, -0.5};  // outside
  EXPECT_GT(TetDomain(in).report().inverted_tets, 0U);
}

TEST(TetDomain, IsTheSameAgainWhenItWasWrittenOut) {
  TaggedTetrahedra in = box(3, 2, 2, left_or_right);
  const auto p = [&](double x, double y, double z) { return point_of(in, x, y, z); };
  add_triangle(in, {p(0, 0, 0), p(1, 0, 0), p(1, 1, 0)}, 7);
  in.edges.corners = {p(2, 1, 1), p(2, 1, 2)};
  in.edge_tags = {9};
  in.fixed = {p(1, 1, 1)};
  const TetDomain once(in);
  const TaggedTetrahedra out = once.tagged();
  EXPECT_EQ(named<4>(out.points, out.tets.corners, out.regions),
            named<4>(in.points, in.tets.corners, in.regions));
  const TetDomain twice(out);
  const TaggedTetrahedra again = twice.tagged();
  EXPECT_EQ(again.points, out.points);
  EXPECT_EQ(again.tets.corners, out.tets.corners);
  EXPECT_EQ(named<3>(again.points, again.triangles.corners, again.patches),
            named<3>(out.points, out.triangles.corners, out.patches));
  EXPECT_EQ(named<2>(again.points, again.edges.corners, again.edge_tags),
            named<2>(out.points, out.edges.corners, out.edge_tags));
  EXPECT_EQ(std::set(again.fixed.begin(), again.fixed.end()), std::set(out.fixed.begin(), out.fixed.end()));
}

double area_of(const TaggedTetrahedra& t) {
  double sum = 0;
  for (std::size_t f = 0; f < t.triangles.size(); ++f) {
    const auto at = [&](std::size_t i) { return Vec3(t.points[t.triangles.facet(f)[i]]); };
    sum += cross(at(1) - at(0), at(2) - at(0)).norm() / 2;
  }
  return sum;
}

// Of the bottom, one patch, the file lists a part with a jagged side. Swaps do not cross it.
TEST(TetDomain, TheListedPartOfAPatchKeepsItsArea) {
  TaggedTetrahedra in = box(4, 4, 2);
  for (std::size_t t = 0; t < in.tets.size(); ++t)
    for (std::size_t without = 0; without < 4; ++without) {
      std::array<Index, 3> v{};
      double sum = 0, height = 0;
      for (std::size_t i = 0, n = 0; i < 4; ++i) {
        if (i == without) continue;
        v[n++] = in.tets.facet(t)[i];
        const auto& p = in.points[in.tets.facet(t)[i]];
        sum += p[0] + 0.5 * p[1], height += p[2];
      }
      if (height == 0 && sum < 9) add_triangle(in, v, 0);
    }
  ASSERT_GT(in.triangles.size(), 4U);
  TetDomain domain(in);
  const double area = area_of(domain.tagged());
  EXPECT_GT(area, 2);
  EXPECT_LT(area, 14);
  Embedding embedding = domain.embedding();
  EmbeddedMesh surface(embedding, *domain.surface());
  std::size_t swaps = 0;
  for (int round = 0; round < 3; ++round)
    for (Index e = 0, end = surface.mesh().capacity(1); e < end; ++e)  // swaps make new ones
      if (surface.mesh().is_live(1, e))
        swaps += static_cast<bool>(surface.operations().swap(surface.node(), surface.mesh().dart_of(1, e)));
  EXPECT_GT(swaps, 4U);
  EXPECT_NEAR(area_of(domain.tagged()), area, 1e-9);
}

TEST(TetDomain, WritesBoundaryTrianglesOutwards) {
  TaggedTetrahedra in = box(1, 1, 1);
  add_triangle(in, {point_of(in, 0, 0, 0), point_of(in, 1, 0, 0), point_of(in, 1, 1, 0)}, 1);
  add_triangle(in, {point_of(in, 0, 0, 1), point_of(in, 1, 0, 1), point_of(in, 1, 1, 1)}, 2);
  const TaggedTetrahedra out = TetDomain(in).tagged();
  ASSERT_EQ(out.triangles.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f) {
    const auto point = [&](std::size_t i) {
      const auto& q = out.points[out.triangles.facet(f)[i]];
      return TetDomain::Point(q[0], q[1], q[2]);
    };
    const TetDomain::Point u = point(1) - point(0), v = point(2) - point(0);
    const double normal_z = u[0] * v[1] - u[1] * v[0];
    EXPECT_EQ(normal_z > 0, out.patches[f] == 2) << "up at the top, down at the bottom";
  }
}

// Two cubes that share one point only: it is copied, held, and one point again in the output.
TEST(TetDomain, CutsAndJoinsPinchedPoints) {
  TaggedTetrahedra in = box(2, 2, 2, [](Index x, Index y, Index z) { return x == y && y == z ? 1 : 2; });
  TaggedTetrahedra pinched;
  pinched.points = in.points;
  for (std::size_t t = 0; t < in.tets.size(); ++t)
    if (in.regions[t] == 1)
      pinched.tets.corners.insert(pinched.tets.corners.end(), in.tets.facet(t).begin(),
                                  in.tets.facet(t).end());
  pinched.tets.vertices = in.tets.vertices;
  TetDomain d(pinched);
  EXPECT_EQ(d.report().copied_vertices, 1U);
  EXPECT_EQ(report(d).tets.components, 1U) << "joined at the point";
  EXPECT_EQ(report(d).tets.face_components, 2U);
  const TaggedTetrahedra out = d.tagged();
  EXPECT_EQ(out.points.size(), 15U);
  EXPECT_EQ(out.fixed.size(), 1U) << "both copies, as one point";
  EXPECT_EQ(out.fixed_flags.at(0), unlisted_simplex);
}

TEST(TetDomain, RefusesListsThatDoNotFit) {
  const auto refused = [](auto change) {
    TaggedTetrahedra in = box(1, 1, 1);
    change(in);
    EXPECT_THROW(TetDomain{in}, InputError);
  };
  refused([](auto& in) { in.regions.pop_back(); });
  refused([](auto& in) { in.tets.corners.clear(), in.regions.clear(); });
  refused([](auto& in) { in.tets.corners[5] = 8; });
  refused([](auto& in) { in.tets.corners[1] = in.tets.corners[0]; });
  refused([](auto& in) { in.triangles.corners = {0, 1, 9}; });
  refused([](auto& in) { in.edge_tags = {1}; });
  refused([](auto& in) { in.fixed = {8}; });
  EXPECT_THROW(TetDomain(box(1, 1, 1), {.feature_angle = 0}), InputError);
}

// Tags follow: after any operations every triangle between regions is there, and volumes of regions, as
// vertices on the surface and the curves stay, are what they were.
TEST(TetDomain, TagsFollowSplitsAndSwaps) {
  TetDomain d(box(2, 2, 2, left_or_right), {.feature_angle = 0.5});
  VertexAttribute<TetDomain::Point> points(NodeId::root, d.points().values);
  Propagation operations(d.tree());
  operations.add(points);
  std::mt19937 random(3);
  for (int i = 0; i < 400; ++i) {
    const tet::TetMesh& mesh = d.mesh();
    Index t;
    do t = static_cast<Index>(random() % mesh.capacity(3));
    while (!mesh.is_live(3, t));
    const Dart e = tet::TetMesh::dart(t, {static_cast<std::uint8_t>(random() % 24)});
    (void)operations.split(NodeId::root, e);
  }
  EXPECT_EQ(validate(d.tree()), std::vector<std::string>{});
  const DomainReport r = report(d);
  EXPECT_EQ(r.inverted_tets, 0U);
  EXPECT_NEAR(r.regions.at(1).volume, 4, 1e-9);
  EXPECT_NEAR(r.regions.at(2).volume, 4, 1e-9);
  const Mesh& surface = d.tree().mesh(*d.surface());
  std::size_t between = 0, listed = 0;
  for (Index s = 0; s < d.mesh().capacity(2); ++s) {
    if (!d.mesh().is_live(2, s)) continue;
    const Dart f = d.mesh().dart_of(2, s), beyond = d.mesh().switch_dart(f, 3);
    const bool wanted =
        beyond == no_dart || d.regions()[tet::TetMesh::tet(f)] != d.regions()[tet::TetMesh::tet(beyond)];
    between += wanted;
    listed += d.tree().facet_over(*d.surface(), f) != no_index;
    EXPECT_EQ(wanted, d.tree().facet_over(*d.surface(), f) != no_index);
  }
  EXPECT_EQ(between, listed);
  EXPECT_EQ(report(surface).faces, listed);
}

}  // namespace
}  // namespace multimesh::test
