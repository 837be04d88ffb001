// SPDX-License-Identifier: BSD-3-Clause
// Sharp edges and borders of labels as curves, their kinds, and that operations keep the kinds.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

constexpr double degrees = std::numbers::pi / 180;

TexturedSurfaceOptions sharp_from(double angle) {
  return {.feature_angle = angle * degrees};
}

/// Eight flat faces of many triangles, whose normals differ by 70.5 degrees across its twelve edges.
TexturedTriangles bare_octahedron() {
  TexturedTriangles s = octahedron().input;
  for (auto& t : s.triangles)
    for (auto& c : t) c.texcoord = -1;
  return s;
}

void expect_octahedron(const CurveReport& r) {
  EXPECT_EQ(r.curves, 12U);
  EXPECT_EQ(r.junctions, 6U);
  EXPECT_EQ(r.ends, 0U);
}

TEST(SharpEdges, AreNoneByDefault) {
  const TexturedSurface surface(bare_octahedron());
  EXPECT_FALSE(surface.seams());
  EXPECT_EQ(report_features(surface).edges, 0U);
  EXPECT_FALSE(report(surface).features);
}

TEST(SharpEdges, AreThoseOfAnOctahedron) {
  const TexturedSurface surface(bare_octahedron(), sharp_from(70));
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  expect_octahedron(report_features(surface));
  EXPECT_EQ(report_seams(surface).edges, 0U);
  EXPECT_FALSE(report(surface).seams) << "sharp edges are no seams";
  ASSERT_TRUE(report(surface).features);
}

TEST(SharpEdges, NeedTheFeatureAngle) {
  EXPECT_FALSE(TexturedSurface(bare_octahedron(), sharp_from(71)).seams());
  EXPECT_TRUE(TexturedSurface(bare_octahedron(), sharp_from(70)).seams());
}

TEST(SharpEdges, OfARightAngleAreSharpAtNinetyDegrees) {
  TexturedTriangles in;
  in.positions = {{0, 0, 0}, {0, 1, 0}, {0.7, 0, 0.7}, {0.7, 0, -0.7}};
  in.triangles = {{{{0}, {1}, {2}}}, {{{1}, {0}, {3}}}};
  EXPECT_TRUE(TexturedSurface(in, sharp_from(90)).seams());
}

TEST(SharpEdges, OnSeamsHaveBothKinds) {
  const TexturedSurface surface(octahedron().input, sharp_from(70));
  const Mesh& curves = surface.tree().mesh(surface.seams().value());
  for (Index e = 0; e < curves.capacity(1); ++e)
    EXPECT_EQ(surface.curve_kinds_of(e), CurveKinds{seam_curve} | sharp_curve);
  expect_octahedron(report_features(surface));
  expect_octahedron(report_seams(surface));
}

TEST(SharpEdges, ThatEndOnASeamDoNotDivideItInTheReport) {
  // A roof whose ridge at x = 10 crosses a seam at y = 10.
  MadeSurface made = with_charts("Roof", grid(20, 20), [](const Vec3& p) { return p[1] < 10; },
                                 {{{{{1, 0, 0, 0}, {0, 1, 0, 0}}}}, {{{{1, 0, 0, 50}, {0, 1, 0, 0}}}}});
  for (auto& p : made.input.positions) p[2] = -std::abs(p[0] - 10);
  const TexturedSurface surface(made.input, sharp_from(60));
  EXPECT_EQ(report_seams(surface).curves, 1U);
  EXPECT_EQ(report_features(surface).curves, 1U);
  EXPECT_EQ(report(surface.tree().mesh(surface.seams().value())).components, 4U) << "they are cut there";
}

TEST(SharpEdges, OfAFaceWithoutAreaAreNone) {
  TexturedTriangles in;
  in.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  in.triangles = {{{{0}, {1}, {2}}}, {{{1}, {0}, {3}}}};
  EXPECT_FALSE(TexturedSurface(in, sharp_from(1)).seams());
}

TEST(SharpEdges, AnAngleOfNothingIsRefused) {
  EXPECT_THROW(TexturedSurface(bare_octahedron(), sharp_from(0)), InputError);
  EXPECT_THROW(TexturedSurface(bare_octahedron(), sharp_from(-1)), InputError);
  EXPECT_THROW(TexturedSurface(bare_octahedron(), sharp_from(std::nan(""))), InputError);
}

TEST(CurveKinds, SurviveDecimation) {
  TexturedSurface surface(octahedron().input, sharp_from(70));
  DecimateOptions options;
  options.faces = 100;
  ASSERT_GT(decimate(surface, options).collapsed, 0U);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  expect_octahedron(report_features(surface));
  expect_octahedron(report_seams(surface));
}

TEST(CurveKinds, SurviveASplit) {
  TexturedSurface surface(octahedron().input, sharp_from(70));
  const Mesh& curves = surface.tree().mesh(surface.seams().value());
  const std::size_t before = report_features(surface).edges;
  const Dart e = surface.tree().to_root(*surface.seams(), curves.dart_of(1, 0));
  Propagation operations(surface.tree());
  const Outcome outcome = operations.split(NodeId::root, e);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(report_features(surface).edges, before + 1);
  EXPECT_EQ(surface.curve_kinds(outcome.root), CurveKinds{seam_curve} | sharp_curve);
}

TEST(CurveKinds, OfAnEdgeOfTheSurface) {
  const TexturedSurface surface(two_charts().input);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::size_t seams = 0;
  for (Index e = 0; e < root.capacity(1); ++e) seams += surface.curve_kinds(root.dart_of(1, e)) == seam_curve;
  EXPECT_EQ(seams, report_seams(surface).edges);
  EXPECT_EQ(TexturedSurface(bare(sphere(1))).curve_kinds(Dart{0}), no_curve);
}

TEST(LabelBorders, CanBeLeftOut) {
  TexturedTriangles in = one_chart().input;
  for (std::size_t t = 0; t < in.triangles.size(); ++t) in.labels.push_back(t < in.triangles.size() / 2);
  const TexturedSurface kept(in), not_kept(in, {.keep_label_borders = false});
  EXPECT_GT(report_curves(kept, label_border_curve).edges, 0U);
  EXPECT_FALSE(report(kept).seams);
  EXPECT_FALSE(not_kept.seams());
}

TEST(Locks, CopiesStayLocked) {
  TexturedSurface surface(book().input);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::size_t copies = 0;
  for (Index v = 0; v < root.capacity(0); ++v) {
    copies += surface.is_copy(v);
    EXPECT_EQ(root.is_locked(v), surface.is_copy(v));
    surface.set_locked(v, true);
    EXPECT_TRUE(root.is_locked(v));
    surface.set_locked(v, false);
    EXPECT_EQ(root.is_locked(v), surface.is_copy(v));
  }
  EXPECT_GT(copies, surface.cut_report().copied_vertices);
}

}  // namespace
}  // namespace multimesh::test
