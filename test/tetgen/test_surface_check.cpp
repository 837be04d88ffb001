// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "adapters/tetgen/worker_error.hpp"
#include "multimesh/error.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/closed_shapes.hpp"

namespace multimesh::test {

namespace {

/// That the surface is refused with words that say what and where.
void expect_refusal(const ClosedSurface& surface, const std::vector<std::string>& words) {
  try {
    tetgen::tetrahedralize(surface.points, surface.triangles);
    ADD_FAILURE() << "was not refused: " << words[0];
  } catch (const InputError& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << word << " is not in: " << error.what();
  }
}

ClosedSurface changed(ClosedSurface surface, const std::function<void(ClosedSurface&)>& change) {
  change(surface);
  return surface;
}

}  // namespace

TEST(SurfaceCheck, RefusesAnOpenSurface) {
  expect_refusal(changed(cube(), [](auto& s) { s.triangles.corners.resize(33); }),
                 {"open", "points 3 and 4", "triangle 10"});
}

TEST(SurfaceCheck, FillsTwoCubesThatShareAnEdge) {
  // Four triangles there.
  ClosedSurface two = cube();
  two.points.insert(two.points.end(),
                    {{-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {-1, 0, 1}, {-1, -1, 1}, {0, -1, 1}});
  const ClosedSurface one = cube();
  const Index image[]{9, 10, 0, 8, 12, 13, 4, 11};
  for (const Index v : one.triangles.corners) two.triangles.corners.push_back(image[v]);
  two.triangles.vertices = 14;
  const auto mesh = tetgen::tetrahedralize(two.points, two.triangles);
  EXPECT_EQ(mesh.winding, (std::vector<int>{1, 1}));
  EXPECT_NEAR(mesh.volume, 2, 1e-12);
}

TEST(SurfaceCheck, RefusesPointsThatAreMissingOrAtOnePlace) {
  expect_refusal(changed(cube(), [](auto& s) { s.triangles.corners[4] = 99; }), {"triangle 1", "point 99"});
  expect_refusal(changed(cube(), [](auto& s) { s.points[6] = s.points[0]; }),
                 {"points 0 and 6", "same place"});
}

TEST(SurfaceCheck, RefusesWhatIsNotFiniteFlatOrEmpty) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_refusal(changed(cube(), [&](auto& s) { s.points[5][2] = bad; }), {"point 5", "not finite"});
  expect_refusal(changed(cube(),
                         [](auto& s) {
                           for (auto& p : s.points)
                             p[2] = 0.1 * (p[0] + 2 * p[1]) + 0 * p[2], p[0] += 1e-3 * p[1];
                           for (std::size_t i = 4; i < 8; ++i) s.points[i][0] += 0.3, s.points[i][2] = 0;
                           for (auto& p : s.points) p[2] = 0;
                         }),
                 {"flat", "axis 2"});
  expect_refusal({}, {"at least 4 triangles"});
  expect_refusal(changed(cube(1e50), [](auto&) {}), {"scale"});
}

TEST(SurfaceCheck, SkewFlatSurfacesEndInAnError) {
  ClosedSurface surface = sphere(1, 1);
  for (auto& p : surface.points) p[2] = p[0] + p[1] + 0.0 * p[2];
  surface.points[4] = {0.01, 0.02, 0.03}, surface.points[5] = {0.02, 0.01, 0.03};
  EXPECT_THROW(tetgen::tetrahedralize(surface.points, surface.triangles), std::runtime_error);
}

TEST(SelfIntersection, NamesTwoTrianglesThatIntersect) {
  // A spike from below through the top of a cube, in every direction of refinement.
  expect_refusal(joined(cube(), sphere(0.5, 1, {1, 0.5, 0.4})), {"intersects itself: triangles "});
  expect_refusal(joined(sphere(1, 3), sphere(1, 3, {0.3, 0.2, 0.1})), {"intersects itself: triangles "});
  ClosedSurface pulled = sphere(1, 3);
  pulled.points[0] = {-3, 0.1, 0.1};  // through the other side
  expect_refusal(pulled, {"intersects itself: triangles ", "near ("});
  // Parts that touch in a face's plane, and along an edge.
  expect_refusal(joined(cube(), changed(cube(0.5),
                                        [](auto& s) {
                                          for (auto& p : s.points) p[2] += 1, p[0] += 0.2, p[1] += 0.1;
                                        })),
                 {"intersects itself: triangles "});
}

}  // namespace multimesh::test
