// SPDX-License-Identifier: BSD-3-Clause
// Real surfaces: closed, open, crossing themselves, not manifold.
#include <gtest/gtest.h>

#include <filesystem>

#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/triangulate.hpp"
#include "test/insertion/check.hpp"

namespace multimesh::test {
namespace {

TriangleSoup read(const std::filesystem::path& path) {
  const io::PolygonSoup file = io::read_mesh(path);
  TriangleSoup soup;
  for (const auto& p : file.positions) soup.points.emplace_back(double(p[0]), double(p[1]), double(p[2]));
  for (const auto& t : io::triangulate(file).triangles)
    for (const auto& c : t) soup.triangles.corners.push_back(static_cast<Index>(c.v));
  soup.triangles.vertices = static_cast<Index>(soup.points.size());
  return soup;
}

class InsertModel : public testing::TestWithParam<const char*> {};

TEST_P(InsertModel, MakesFacesOfAllTriangles) {
  const std::filesystem::path shared = MULTIMESH_SHARED_DATA, own = MULTIMESH_EXAMPLE_DATA;
  const std::filesystem::path path = exists(own / GetParam()) ? own / GetParam() : shared / GetParam();
  if (!exists(path)) GTEST_SKIP() << path << " is not there";
  const TriangleSoup soup = read(path);
  const BackgroundMesh background = background_of(soup, bounding_box_diagonal(soup.points) / 20);
  InsertOptions options;
  options.round = false;
  const Arrangement a = insert(soup, background, options);
  EXPECT_EQ(faults(soup, background, a), std::vector<std::string>{});
}
INSTANTIATE_TEST_SUITE_P(Files, InsertModel,
                         testing::Values("spot/spot.obj", "thingi10k/37989_sf.obj", "thingi10k/42291.stl",
                                         "thingi10k/63465.stl", "surface_dirty/cow.obj",
                                         "surface_dirty/klein_bottle_blocky.obj",
                                         "surface_dirty/self_intersectA.obj",
                                         "surface_dirty/three_cubes.stl"),
                         [](const auto& file) {
                           std::string name = std::filesystem::path(file.param).stem().string();
                           std::erase(name, '_');
                           return name;
                         });

}  // namespace
}  // namespace multimesh::test
