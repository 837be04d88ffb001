// SPDX-License-Identifier: BSD-3-Clause
// Surfaces read and written in two lines, with materials, groups and warnings.
#include "multimesh/algorithms/surface_topology.hpp"
#include "multimesh/files/materials.hpp"
#include "multimesh/files/surface_file.hpp"
#include "test/files/folder.hpp"

namespace multimesh::files::test {
namespace {

const std::string spot = MULTIMESH_EXAMPLE_DATA "/spot/spot.obj";

class Surface : public InFolder {};

/// Corner by corner the values, so that the numbers of vertices do not count.
std::vector<std::array<double, 5>> corners(const TexturedTriangles& t) {
  std::vector<std::array<double, 5>> list;
  for (const auto& triangle : t.triangles)
    for (const auto& c : triangle) {
      const auto& p = t.positions[static_cast<std::size_t>(c.position)];
      const auto& uv = t.texcoords[static_cast<std::size_t>(c.texcoord)];
      list.push_back({p[0], p[1], p[2], uv[0], uv[1]});
    }
  std::ranges::sort(list);
  return list;
}

TEST_F(Surface, IsTheSameWhenItIsWrittenAndRead) {
  SurfaceFile file = read_surface(spot);
  const TexturedTriangles input = file.input;
  const TexturedSurface surface = take_surface(file);
  EXPECT_TRUE(file.input.triangles.empty());
  EXPECT_EQ(write_surface(folder / "out.obj", surface, file), std::vector<std::string>{});
  const SurfaceFile again = read_surface(folder / "out.obj");
  EXPECT_EQ(corners(again.input), corners(input));
  EXPECT_EQ(again.section_of(0).material, file.section_of(0).material);
}

TEST_F(Surface, KeepsItsTextureInAnotherDirectory) {
  SurfaceFile file = read_surface(spot);
  write_surface(folder / "out.obj", take_surface(file), file);
  const SurfaceFile again = read_surface(folder / "out.obj", {.follow_paths = true});
  const MaterialsInUse in_use = materials_in_use(again, {0, 1});
  ASSERT_EQ(in_use.materials.size(), 1U);
  EXPECT_EQ(in_use.of_triangle, (std::vector<Index>{0, 0}));
  EXPECT_TRUE(std::filesystem::equivalent(in_use.materials[0].texture,
                                          MULTIMESH_EXAMPLE_DATA "/spot/spot_texture.png"));
}

TEST_F(Surface, SaysWhatWasDoneToTheInputAndPrintsNothing) {
  const auto path = write("in.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                          "f 1 2 3\nf 4 5 6\n");
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  SurfaceFile file = read_surface(path);
  const TexturedSurface surface = take_surface(file);
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_TRUE(any_has(file.warnings, "joined with it"));
  EXPECT_TRUE(any_has(file.warnings, "turned round"));
  EXPECT_EQ(topology_of(surface).components, 1U);
}

TEST_F(Surface, VerticesStayApartIfAskedFor) {
  const auto path = write("in.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                          "f 1 2 3\nf 4 6 5\n");
  SurfaceReadOptions apart;
  apart.weld.positions = false;
  SurfaceFile file = read_surface(path, apart);
  EXPECT_EQ(topology_of(take_surface(file)).components, 2U);
}

TEST_F(Surface, MaterialsAreLabels) {
  const auto path = write("in.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                          "usemtl a\nf 1 2 3\nusemtl b\nf 2 4 3\n");
  const SurfaceFile file = read_surface(path);
  ASSERT_EQ(file.input.labels.size(), 2U);
  EXPECT_NE(file.input.labels[0], file.input.labels[1]);
  EXPECT_EQ(file.section_of(0).material, "a");
  EXPECT_EQ(file.section_of(1).material, "b");
}

TEST_F(Surface, ErrorsNameTheFileAndWhatToDo) {
  const auto tets = write("tets.mesh",
                          "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                          "0 0 1 0\nTetrahedra 1\n1 2 3 4 1\nEnd\n");
  const std::string why = refusal([&] { read_surface(tets); });
  EXPECT_NE(why.find("tets.mesh"), std::string::npos) << why;
  EXPECT_NE(why.find("give a surface"), std::string::npos) << why;
  const auto far = write("far.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n");
  EXPECT_NE(refusal([&] { read_surface(far); }).find("far.obj"), std::string::npos);
  const auto good = write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  SurfaceFile file = read_surface(good);
  EXPECT_NE(refusal([&] { take_surface(file, {.feature_angle = -1}); }).find("good.obj"), std::string::npos);
}

TEST_F(Surface, PlainListsAreWrittenAsTheyAre) {
  const SurfaceFile file = read_surface(spot);
  write_surface(folder / "out.obj", file.input);
  EXPECT_EQ(corners(read_surface(folder / "out.obj").input), corners(file.input));
}

TEST_F(Surface, TellsOfWhatTheFormatHasNoRoomFor) {
  SurfaceFile file = read_surface(spot);
  TexturedTriangles two = file.input;
  two.more_uv_sets.push_back({two.texcoords, {}});
  for (const auto& t : two.triangles)
    two.more_uv_sets[0].corners.push_back({t[0].texcoord, t[1].texcoord, t[2].texcoord});
  EXPECT_TRUE(any_has(write_surface(folder / "two.obj", two), "only the first of 2 sets"));
  const TexturedSurface surface = take_surface(file);
  EXPECT_TRUE(any_has(write_surface(folder / "out.stl", surface, file), "texture coordinates"));
}

}  // namespace
}  // namespace multimesh::files::test
