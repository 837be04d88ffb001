// SPDX-License-Identifier: BSD-3-Clause
// Several sets of texture coordinates, and vertex colours: a round trip, and what the tree has of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

/// Adds a set, one texture coordinate per corner; triangles of which `has` is false stay without.
void add_set(
    TexturedTriangles& s, const Unwrap& unwrap,
    const std::function<bool(std::size_t)>& has = [](std::size_t) { return true; }) {
  auto& set = s.more_uv_sets.emplace_back();
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    auto& corners = set.corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = has(t) ? static_cast<std::int32_t>(set.texcoords.size()) : -1;
      set.texcoords.push_back(unwrap(t, s.positions[static_cast<std::size_t>(s.triangles[t][i].position)]));
    }
  }
}

Vec3 centroid(const TexturedTriangles& s, std::size_t t) {
  Vec3 sum(0, 0, 0);
  for (const auto& c : s.triangles[t]) sum += s.positions[static_cast<std::size_t>(c.position)];
  return sum / 3.0;
}

/// Two charts, one for each half in y.
void add_lower_and_upper(TexturedTriangles& s, double middle = 10) {
  add_set(s, [&](std::size_t t, const Vec3& p) {
    return Vec2(p[0] + (centroid(s, t)[1] < middle ? 0 : 100), p[1] + p[2] / 4);
  });
}

/// Position and texture coordinates of all sets, by value; -1 -1 where there are none.
std::vector<double> corner(const TexturedTriangles& s, std::size_t t, std::size_t i) {
  const Vec3& p = s.positions[static_cast<std::size_t>(s.triangles[t][i].position)];
  std::vector<double> result(p.data(), p.data() + 3);
  for (std::size_t set = 0; set < s.uv_sets(); ++set) {
    const std::int32_t vt = s.texcoord(set, t, i);
    const Vec2 uv = vt < 0 ? Vec2(-1, -1) : s.texcoords_of(set)[static_cast<std::size_t>(vt)];
    result.insert(result.end(), uv.data(), uv.data() + 2);
  }
  return result;
}

bool same_triangle(const TexturedTriangles& x, std::size_t t, const TexturedTriangles& y, std::size_t u) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < 3; ++i) same &= corner(x, t, i) == corner(y, u, (i + turn) % 3);
    if (same) return true;
  }
  return false;
}

class UvSets : public ::testing::TestWithParam<MadeSurface> {};

TEST_P(UvSets, ComeOutAsTheyWentIn) {
  TexturedTriangles in = GetParam().input;
  add_lower_and_upper(in);
  add_set(
      in, [](std::size_t t, const Vec3& p) { return Vec2(p[0] + double(t % 2), p[2]); },
      [](std::size_t t) { return t % 3 != 0; });
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  ASSERT_EQ(surface.textures().size(), 3U);
  EXPECT_EQ(surface.texture(), surface.textures().front());
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  ASSERT_EQ(out.triangles.size(), in.triangles.size());
  ASSERT_EQ(out.uv_sets(), 3U);
  for (std::size_t t = 0; t < source.size(); ++t)
    ASSERT_TRUE(same_triangle(out, t, in, source[t])) << "triangle " << source[t];
}

INSTANTIATE_TEST_SUITE_P(Surfaces, UvSets, ::testing::ValuesIn(made_surfaces()),
                         [](const auto& p) { return p.param.name; });

TEST(UvSets, EachHasItsOwnSeams) {
  TexturedTriangles in = two_charts().input;  // a seam at x = 10
  add_lower_and_upper(in);                    // and one at y = 10
  add_set(in, [](std::size_t, const Vec3& p) { return Vec2(p[0], p[1]); });
  const TexturedSurface surface(in);
  for (const std::size_t set : {0, 1}) {
    const SeamReport r = report_seams(surface, set);
    EXPECT_EQ(r.curves, 1U);
    EXPECT_EQ(r.ends, 2U);
    EXPECT_EQ(r.edges, 20U);
  }
  EXPECT_EQ(report_seams(surface, 2).edges, 0U);
  const MeshReport curves = report(surface.tree().mesh(surface.seams().value()));
  EXPECT_EQ(curves.components, 4U) << "both are cut where they cross";
  const SurfaceReport r = report(surface);
  ASSERT_EQ(r.more_uv_sets.size(), 2U);
  EXPECT_EQ(r.texture.value().components, 2U);
  EXPECT_EQ(r.more_uv_sets[0].texture.components, 2U);
  EXPECT_EQ(r.more_uv_sets[1].texture.components, 1U);
  EXPECT_FALSE(r.more_uv_sets[1].seams);
}

TEST(UvSets, SeamsOfTwoOnTheSameEdgesAreOneCurve) {
  TexturedTriangles in = two_charts().input;
  add_set(in, [&](std::size_t t, const Vec3& p) {
    return Vec2(p[0], p[1] + (centroid(in, t)[0] < 10 ? 0 : 30));
  });
  const TexturedSurface surface(in);
  EXPECT_EQ(report(surface.tree().mesh(surface.seams().value())).components, 1U);
  EXPECT_EQ(surface.curve_kinds_of(0), seam_of(0) | seam_of(1));
}

TEST(UvSets, ACurveEndsWhereASecondSetsSeamLeavesIt) {
  TexturedTriangles in = two_charts().input;
  const auto cut_from = [&](std::size_t t) { return centroid(in, t)[0] < 10 ? 0.0 : 1.0; };
  add_set(in, [&](std::size_t t, const Vec3& p) {  // a slit on the upper half of the first set's seam
    return Vec2(p[0] + cut_from(t) * std::max(0.0, p[1] - 10), p[1]);
  });
  const TexturedSurface surface(in);
  const MeshReport curves = report(surface.tree().mesh(surface.seams().value()));
  EXPECT_EQ(curves.components, 2U);
  EXPECT_EQ(report_seams(surface, 0).curves, 1U);
  EXPECT_EQ(report_seams(surface, 1).edges, 10U);
}

TEST(UvSets, BordersOfAPartHaveTheirKind) {
  TexturedTriangles in = one_chart().input;
  const std::vector<Vec3> positions = in.positions;
  add_set(
      in, [](std::size_t, const Vec3& p) { return Vec2(p[0], p[1]); },
      [&](std::size_t t) { return centroid(in, t)[0] < 10; });
  const TexturedSurface surface(in);
  EXPECT_EQ(surface.curve_kinds_of(0), texture_border_of(1));
  EXPECT_EQ(surface.cut_report().triangles_without_texcoords, 0U) << "of set 0";
}

TEST(UvSets, KindsDoNotCoincide) {
  CurveKinds all =
      seam_curve | texture_border_curve | reversed_border_curve | label_border_curve | sharp_curve;
  for (std::size_t set = 1; set < max_uv_sets; ++set)
    for (const CurveKinds kind : {seam_of(set), texture_border_of(set)}) {
      EXPECT_NE(kind, 0U);
      EXPECT_EQ(all & kind, 0U) << set;
      all |= kind;
    }
}

TEST(UvSets, WrongOnesAreRefused) {
  const TexturedTriangles good = two_charts().input;
  TexturedTriangles in = good;
  in.more_uv_sets.emplace_back();
  EXPECT_THROW(TexturedSurface{in}, InputError) << "no corners";
  add_set(in = good, [](std::size_t, const Vec3&) { return Vec2(0, 0); });
  in.more_uv_sets[0].corners[5][1] = -1;
  EXPECT_THROW(TexturedSurface{in}, InputError) << "some corners only";
  in.more_uv_sets[0].corners[5] = {-1, 0, 1000000};
  EXPECT_THROW(TexturedSurface{in}, InputError) << "out of range";
  add_set(
      in = good, [](std::size_t, const Vec3&) { return Vec2(0, 0); }, [](std::size_t) { return false; });
  EXPECT_THROW(TexturedSurface{in}, InputError) << "a set of nothing";
  in = good;
  for (std::size_t i = 0; i < max_uv_sets; ++i) add_lower_and_upper(in);
  EXPECT_THROW(TexturedSurface{in}, InputError) << "too many";
}

TEST(Colors, ComeOutAsTheyWentIn) {
  for (const MadeSurface& made : made_surfaces()) {
    TexturedTriangles in = made.input;
    for (std::size_t v = 0; v < in.positions.size(); ++v)
      in.colors.push_back({double(v % 7) / 7, double(v % 11) / 11, double(v % 13) / 13});
    const TexturedSurface surface(in);
    EXPECT_EQ(surface.colors().size(), surface.positions().size());
    std::vector<Index> source;
    const TexturedTriangles out = surface.triangles(source);
    ASSERT_EQ(out.colors.size(), out.positions.size());
    for (std::size_t t = 0; t < source.size(); ++t) {
      std::vector<std::array<double, 6>> found, expected;
      const auto collect = [](const TexturedTriangles& s, std::size_t f, auto& list) {
        for (const auto& c : s.triangles[f]) {
          const Vec3 &p = s.positions[static_cast<std::size_t>(c.position)],
                     &q = s.colors[static_cast<std::size_t>(c.position)];
          list.push_back({p[0], p[1], p[2], q[0], q[1], q[2]});
        }
        std::sort(list.begin(), list.end());
      };
      collect(out, t, found), collect(in, source[t], expected);
      ASSERT_EQ(found, expected) << made.name;
    }
  }
}

TEST(Colors, AreNoneWithoutAny) {
  const TexturedSurface surface(one_chart().input);
  EXPECT_TRUE(surface.colors().empty());
  std::vector<Index> source;
  EXPECT_TRUE(surface.triangles(source).colors.empty());
  TexturedTriangles in = one_chart().input;
  in.colors.resize(3);
  EXPECT_THROW(TexturedSurface{in}, InputError);
}

}  // namespace
}  // namespace multimesh::test
