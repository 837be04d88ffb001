// SPDX-License-Identifier: BSD-3-Clause
#include "test/improve/domain_contract.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "multimesh/validate.hpp"
#include "test/improve/flat_list_check.hpp"
#include "test/improve/made_domain.hpp"
#include "test/improve/random_solid.hpp"

namespace multimesh::test {

namespace {

template <std::size_t n>
std::array<std::array<double, 3>, n> points_of(const TaggedTetrahedra& t, std::span<const Index> facet) {
  std::array<std::array<double, 3>, n> p;
  for (std::size_t i = 0; i < n; ++i) p[i] = t.points[facet[i]];
  std::ranges::sort(p);
  return p;
}

auto tets_of_region(const TaggedTetrahedra& t, TetDomain::Tag region) {
  std::multiset<std::array<std::array<double, 3>, 4>> all;
  for (std::size_t i = 0; i < t.tets.size(); ++i)
    if (t.regions[i] == region) all.insert(points_of<4>(t, t.tets.facet(i)));
  return all;
}

}  // namespace

std::set<std::array<std::array<double, 3>, 3>> triangles_of_patch(const TaggedTetrahedra& t,
                                                                  TetDomain::Tag tag) {
  std::set<std::array<std::array<double, 3>, 3>> all;
  for (std::size_t i = 0; i < t.triangles.size(); ++i)
    if (t.patches[i] == tag) all.insert(points_of<3>(t, t.triangles.facet(i)));
  return all;
}

void expect_locked_patches_keep_their_triangles(const OnDomain& run) {
  const Box box = make_box({});
  TetDomain domain(box.input);
  const TaggedTetrahedra before = domain.tagged();
  const DomainLocks locks{.locked_patches = {11, 3}};
  run(domain, locks);
  const TaggedTetrahedra after = domain.tagged();
  for (const TetDomain::Tag tag : locks.locked_patches)
    EXPECT_EQ(triangles_of_patch(after, tag), triangles_of_patch(before, tag)) << tag;
  EXPECT_NE(triangles_of_patch(after, 12), triangles_of_patch(before, 12));
}

void expect_locked_regions_keep_their_tetrahedra(const OnDomain& run) {
  const Box box = make_box({});
  TetDomain domain(box.input);
  run(domain, {.locked_regions = {1}});
  const TaggedTetrahedra after = domain.tagged();
  EXPECT_EQ(tets_of_region(after, 1), tets_of_region(box.input, 1));
  EXPECT_NE(tets_of_region(after, 2), tets_of_region(box.input, 2));
}

void expect_required_triangles_stay(const OnDomain& run) {
  Box box = make_box({});
  box.input.triangle_flags.assign(box.input.triangles.size(), 0);
  for (std::size_t i = 0; i < box.input.triangles.size(); ++i)
    if (box.input.patches[i] == 14) box.input.triangle_flags[i] = required_simplex;
  TetDomain domain(box.input);
  run(domain, {});
  const TaggedTetrahedra after = domain.tagged();
  EXPECT_EQ(triangles_of_patch(after, 14), triangles_of_patch(box.input, 14));
  EXPECT_NE(triangles_of_patch(after, 12), triangles_of_patch(box.input, 12));
}

void expect_a_domain_without_surface_is_refused(const OnDomain& run) {
  TetDomainOptions none;
  none.boundary = none.interfaces = false;
  BoxOptions plain;
  plain.sheet = plain.curve = false;
  TaggedTetrahedra input = make_box(plain).input;
  input.triangles = FacetList{2, 0, {}};
  input.patches.clear();
  TetDomain domain(input, none);
  EXPECT_THROW(run(domain, {}), InputError);
}

void expect_the_same_twice(const OnDomain& run) {
  const auto result = [&] {
    TetDomain domain(make_box({}).input);
    run(domain, {});
    return domain.tagged();
  };
  const TaggedTetrahedra a = result(), b = result();
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets.corners, b.tets.corners);
}

void expect_solids_stay_what_they_are(const std::function<bool(TetDomain&, unsigned)>& run, double tolerance,
                                      std::size_t least_changed) {
  std::size_t with_copies = 0, changed = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TaggedTetrahedra list = RandomSolid(seed).list();
    TetDomainOptions sharp;
    sharp.feature_angle = std::numbers::pi / 180;  // each of its faces is plane
    TetDomain domain(list, sharp);
    with_copies += domain.report().copied_vertices > 0;
    changed += run(domain, seed);
    EXPECT_EQ(compare(facts_of(list), facts_of(domain.tagged()), tolerance), "");
    EXPECT_TRUE(all_positive(domain));
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  }
  EXPECT_GT(with_copies, 20U);
  EXPECT_GT(changed, least_changed);
}

}  // namespace multimesh::test
