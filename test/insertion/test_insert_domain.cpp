// SPDX-License-Identifier: BSD-3-Clause
// Arrangements as lists: regions, patches, and the tree that is built from them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "multimesh/algorithms/insert_domain.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/validate.hpp"
#include "test/insertion/check.hpp"
#include "test/insertion/soups.hpp"

namespace multimesh::test {
namespace {

std::map<TaggedTetrahedra::Tag, double> volumes(const TaggedTetrahedra& t) {
  std::map<TaggedTetrahedra::Tag, double> sums;
  for (std::size_t i = 0; i < t.tets.size(); ++i) {
    const auto v = t.tets.facet(i);
    const auto at = [&](std::size_t k) { return Vec3(t.points[v[k]]); };
    sums[t.regions[i]] += six_volume(at(0), at(1), at(2), at(3)) / 6;
  }
  return sums;
}

/// Two cubes of edge 2, the second shifted by (1, 1, 1), with labels 1 and 2.
TriangleSoup two_cubes(const Vec3& shift) {
  TriangleSoup soup = cube({0, 0, 0}, 2);
  const TriangleSoup other = cube(shift, 2);
  const auto first = static_cast<Index>(soup.points.size());
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for (const Index v : other.triangles.corners) soup.triangles.corners.push_back(first + v);
  soup.triangles.vertices = static_cast<Index>(soup.points.size());
  soup.labels.assign(12, 1);
  soup.labels.resize(24, 2);
  return soup;
}

TEST(InsertDomain, CrossingCubesMakeThreeRegions) {
  const TriangleSoup soup = two_cubes({1, 1, 1});
  const Arrangement a = insert(soup, background_of(soup, 0.7));
  const ArrangementLists lists = lists_of(a, soup);
  EXPECT_EQ(a.report.unrounded, 0U);
  EXPECT_EQ(lists.regions, 4);  // with that outside
  EXPECT_EQ(lists.inverted, 0U);
  EXPECT_TRUE(lists.overlaps.empty());
  auto sizes = volumes(lists.tets);
  sizes.erase(1);
  std::multiset<double> rounded;
  for (const auto& [region, volume] : sizes) rounded.insert(std::round(volume * 1e9) / 1e9);
  EXPECT_EQ(rounded, (std::multiset<double>{1, 7, 7}));
  TetDomainOptions only_listed;
  only_listed.boundary = only_listed.interfaces = false;
  TetDomain domain(lists.tets, only_listed);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_EQ(domain.report().missing_triangles, 0U);
  ASSERT_TRUE(domain.curves());  // where they cross
}

TEST(InsertDomain, FacesOfTwoLabelsHaveATagOfTheirOwn) {
  const TriangleSoup soup = two_cubes({2, 0, 0});  // a side in common
  const ArrangementLists lists = lists_of(insert(soup, background_of(soup)), soup);
  EXPECT_EQ(lists.regions, 3);
  ASSERT_EQ(lists.overlaps.size(), 1U);
  EXPECT_EQ(lists.overlaps[0].labels, (std::vector<TaggedTetrahedra::Tag>{1, 2}));
  std::map<TaggedTetrahedra::Tag, double> areas;
  for (std::size_t f = 0; f < lists.tets.triangles.size(); ++f) {
    const auto v = lists.tets.triangles.facet(f);
    const auto at = [&](std::size_t k) { return Vec3(lists.tets.points[v[k]]); };
    areas[lists.tets.patches[f]] += cross(at(1) - at(0), at(2) - at(0)).norm() / 2;
  }
  EXPECT_NEAR(areas[1], 20, 1e-9);
  EXPECT_NEAR(areas[2], 20, 1e-9);
  EXPECT_NEAR(areas[lists.overlaps[0].tag], 4, 1e-9);
}

TEST(InsertDomain, RoundingLeavesTetrahedraPositive) {
  for (const SoupKind& kind : soup_kinds())
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const TriangleSoup soup = kind.make(seed);
      const Arrangement a = insert(soup, background_of(soup));
      const ArrangementLists lists = lists_of(a, soup);
      EXPECT_TRUE(lists.inverted == 0 || a.report.unrounded > 0) << kind.name << seed;
      EXPECT_EQ(lists.tets.triangles.size(), a.faces.size());
    }
}

TEST(Insert, MorePointsThanAllowedAreRefused) {
  const TriangleSoup soup = soup_kinds().front().make(3);
  InsertOptions few;
  few.most_points = 3;
  EXPECT_THROW((void)insert(soup, background_of(soup), few), InputError);
}

TEST(Insert, GivesTheSameTwice) {
  const TriangleSoup soup = soup_kinds().front().make(2);
  const BackgroundMesh background = background_of(soup, 0.3);
  const Arrangement a = insert(soup, background), b = insert(soup, background);
  EXPECT_EQ(a.tets.corners, b.tets.corners);
  EXPECT_EQ(a.faces.corners, b.faces.corners);
}

}  // namespace
}  // namespace multimesh::test
