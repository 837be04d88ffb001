// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "multimesh/error.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/surface_file.hpp"
#include "test/tetgen/tet_facts.hpp"

namespace multimesh::test {

namespace {

/// A file of the collection of test meshes; how it must end: filled when `error` is empty, else with an error
/// that contains it.
struct RealSurface {
  const char* file;
  const char* error = "";
  friend std::ostream& operator<<(std::ostream& out, const RealSurface& surface) {
    return out << surface.file;
  }
};

class RealSurfaces : public testing::TestWithParam<RealSurface> {};

}  // namespace

TEST_P(RealSurfaces, AreFilledOrRefused) {
  const std::filesystem::path path = std::filesystem::path(MULTIMESH_SHARED_DATA) / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const ClosedSurface surface = read_surface(path);
  const std::string expected = GetParam().error;
  const auto start = std::chrono::steady_clock::now();
  std::string outcome = "filled";
  std::size_t tets = 0;
  try {
    const tetgen::Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
    tets = mesh.tets.size();
    const TetFacts facts = facts_of(mesh);
    // Below 0 only by the rounding of this double-precision sum; the library has tested the signs exactly.
    EXPECT_GT(facts.least, -1e-12 * facts.volume);
    EXPECT_EQ(facts.bad_faces, 0u);
    EXPECT_NEAR(facts.volume, mesh.volume, 1e-9 * mesh.volume);
    EXPECT_GE(mesh.faces.size() + mesh.facets.flat, surface.triangles.size());
    EXPECT_EQ(expected, "");
  } catch (const InputError& error) {
    outcome = error.what();
    EXPECT_FALSE(expected.empty()) << outcome;
    EXPECT_NE(outcome.find(expected), std::string::npos) << outcome;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::cout << path.filename().string() << " | " << surface.triangles.size() << " | " << tets << " | "
            << std::fixed << std::setprecision(2) << seconds.count() << " s | " << outcome << '\n';
}

INSTANTIATE_TEST_SUITE_P(Closed, RealSurfaces,
                         testing::ValuesIn(std::vector<RealSurface>{
                             {"surface_closed/Chassis_-_upright_f_l-1_front_upright-1_B9-1.off"},
                             {"surface_closed/Offset2.obj"},
                             {"surface_closed/bamboo_pen.obj"},
                             {"surface_closed/borromean.obj"},
                             {"surface_closed/channel_6inch.stl"},
                             {"surface_closed/cheese.off"},
                             {"surface_closed/couplingdown.off"},
                             {"surface_closed/elephant.off"},
                             {"surface_closed/fandisk.off"},
                             {"surface_closed/fertility_quad.off"},
                             {"surface_closed/fertility_tri.off"},
                             {"surface_closed/pelvis_f.obj"},
                             {"surface_closed/plate_holes.STL"},
                             {"surface_closed/turbine.off"},
                             {"thingi10k/37322.stl"},
                             {"thingi10k/37384.stl"},
                             {"thingi10k/43959.stl"},
                             {"thingi10k/44901.stl"},
                             {"thingi10k/47076.stl"},
                             {"thingi10k/52134.stl"},
                             {"thingi10k/54227.stl"},
                             {"thingi10k/57657.stl"},
                             {"thingi10k/61458.stl"},
                             {"thingi10k/65395.stl"},
                             {"thingi10k/65778.stl"},
                             {"thingi10k/72214.stl"},
                             {"thingi10k/100071_sf.obj"},
                             {"thingi10k/112544.off"},
                             {"thingi10k/472042.stl"},
                             {"thingi10k/520644.stl"},
                             {"thingi10k/550964.stl"},
                             {"thingi10k/1146164.off"},
                         }));

// They intersect themselves by the rounding of coordinates.
INSTANTIATE_TEST_SUITE_P(Rounded, RealSurfaces,
                         testing::ValuesIn(std::vector<RealSurface>{
                             {"thingi10k/37863.stl"},
                             {"thingi10k/51660.stl"},
                             {"thingi10k/93703.stl"},
                         }));

INSTANTIATE_TEST_SUITE_P(
    SelfIntersecting, RealSurfaces,
    testing::ValuesIn(std::vector<RealSurface>{
        {"thingi10k/93068.stl", "intersects itself: triangles "},
        {"textured/camel_seamster/camel_f_withSUV.obj", "points 946 and 1789 are at the same place"},
        {"surface_dirty/Generic_Twin_7863.1.t0_right.obj", "intersects itself: triangles "},
        {"surface_dirty/al.obj", "intersects itself: triangles "},
        {"textured/SOFA_pod/SOFA_pod.obj", "intersects itself: triangles "},
    }));

INSTANTIATE_TEST_SUITE_P(NotClosedManifold, RealSurfaces,
                         testing::ValuesIn(std::vector<RealSurface>{
                             {"thingi10k/49883.stl", "intersects itself: triangles "},
                             {"thingi10k/52069.stl"},
                             {"thingi10k/54137.stl"},
                             {"thingi10k/134617.stl", "open: the edge between points "},
                             {"thingi10k/68435.stl", "open: the edge between points "},
                             {"thingi10k/12246.stl", "intersects itself: triangles "},
                         }));

}  // namespace multimesh::test
