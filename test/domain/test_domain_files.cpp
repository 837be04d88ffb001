// SPDX-License-Identifier: BSD-3-Clause
// The collection's tetrahedral files: read, made a domain, ten thousand operations, written, read again.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "adapters/io/repeated_simplices.hpp"
#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/domains/joined_mesh.hpp"
#include "multimesh/files/domain_file.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/io/simplex_writer.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"

namespace multimesh::test {
namespace {

namespace fs = std::filesystem;

TaggedTetrahedra tagged(io::SimplexSoup soup) {
  files::DomainFile file{{}, std::move(soup), {}};
  return files::take_tetrahedra(file);
}

io::SimplexSoup soup(const TaggedTetrahedra& t) {
  io::SimplexSoup s;
  s.points = t.points;
  s.simplices[0] = {t.fixed, std::vector<std::int32_t>(t.fixed.size(), 0), {}};
  s.simplices[1] = {t.edges.corners, t.edge_tags, {}};
  s.simplices[2] = {t.triangles.corners, t.patches, {}};
  s.simplices[3] = {t.tets.corners, t.regions, {}};
  return s;
}

/// What no operation may change: of every mesh, its Euler characteristic, components and boundary.
std::vector<long> topology(const TetDomain& d) {
  const DomainReport r = report(d);
  std::vector<long> t{static_cast<long>(r.tets.components), r.tets.euler_characteristic,
                      static_cast<long>(r.tets.boundary_components), r.tets.boundary_euler_characteristic};
  for (const auto* m : {r.surface ? &*r.surface : nullptr, r.curves ? &*r.curves : nullptr})
    if (m)
      t.insert(t.end(),
               {static_cast<long>(m->components), m->euler_characteristic, static_cast<long>(m->boundary)});
  t.push_back(static_cast<long>(r.fixed_points));
  return t;
}

Dart random_dart(const Mesh& mesh, std::mt19937& random) {
  const int d = mesh.dimension();
  Index f;
  do f = static_cast<Index>(random() % mesh.capacity(d));
  while (!mesh.is_live(d, f));
  return mesh.reorder(mesh.dart_of(d, f), {static_cast<std::uint8_t>(random() % (d == 3   ? 24
                                                                                 : d == 2 ? 6
                                                                                          : 2))});
}

/// Until `wanted` operations were done. Fewer splits than collapses, so that the mesh does not grow.
void storm(TetDomain& d, int wanted, std::mt19937& random) {
  VertexAttribute<TetDomain::Point> points(NodeId::root, d.points().values);
  Propagation operations(d.tree());
  operations.add(points);
  KeepsJoinedMesh joined(d);
  operations.add(joined);
  for (int done = 0, tried = 0; done < wanted && tried < 20 * wanted; ++tried) {
    const auto nodes = d.tree().nodes();
    const NodeId n = nodes[random() % nodes.size()];
    if (d.tree().mesh(n).dimension() == 0) continue;  // points have no edges
    const Dart e = random_dart(d.tree().mesh(n), random);
    switch (random() % 6) {
      case 0:
      case 1:
        done += bool(operations.split(n, e));
        break;
      case 2:
      case 3:
        done += bool(operations.collapse(n, e));
        break;
      case 4:
        done += bool(operations.swap(n, e));
        break;
      default:
        done += bool(operations.swap_face(n, e));
    }
    if (tried % 2500 == 2499) {
      ASSERT_EQ(validate(d.tree()), std::vector<std::string>{});
    }
  }
}

class DomainFile : public testing::TestWithParam<const char*> {};

TEST_P(DomainFile, SurvivesOperationsAndAFile) {
  const fs::path path = fs::path(MULTIMESH_SHARED_DATA) / GetParam();
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not there";
  TetDomain d(tagged(io::read_simplices(path)));
  ASSERT_EQ(validate(d.tree()), std::vector<std::string>{});
  EXPECT_EQ(d.report().missing_triangles + d.report().missing_edges, 0U);
  const std::vector<long> before = topology(d);
  std::mt19937 random(5);
  storm(d, 10'000, random);
  d.tree().compact();
  EXPECT_EQ(validate(d.tree()), std::vector<std::string>{});
  EXPECT_EQ(topology(d), before);

  // The storm does not look at positions: where copies of points touch, it may make two tetrahedra of the
  // same points, which are one in a file.
  io::SimplexSoup written = soup(d.tagged());
  io::unite_repeated_simplices(written);
  const TaggedTetrahedra out = tagged(written);
  const fs::path file = fs::temp_directory_path() / ("multimesh-domain-" + std::to_string(getpid()) + ".vtu");
  io::write_simplices(file, written);
  const TaggedTetrahedra again = tagged(io::read_simplices(file));
  fs::remove(file);
  EXPECT_EQ(again.points, out.points);
  EXPECT_EQ(again.tets.corners, out.tets.corners);
  EXPECT_EQ(again.regions, out.regions);
  EXPECT_EQ(again.triangles.corners, out.triangles.corners);
  EXPECT_EQ(again.patches, out.patches);
  EXPECT_EQ(again.edges.corners, out.edges.corners);
  EXPECT_EQ(again.edge_tags, out.edge_tags);
}

INSTANTIATE_TEST_SUITE_P(
    Collection, DomainFile,
    testing::Values("tet/Armadillo_Tetra_4406.vtu", "tet/Cleaver2_basic_output.msh",
                    "tet/Cleaver2_basic_output.node", "tet/armadillo.msh.gz", "tet/beam-tet.mesh",
                    "tet/box_cavity_coarse.msh", "tet/bunny_tetwild_80.msh.gz", "tet/cube.mesh",
                    "tet/cubes_v41.msh.gz", "tet/elephant.mesh", "tet/left_finger.msh.gz",
                    "tet/neper_n20_simulation.msh", "tet/neper_statelt2d_ref.msh", "tet/nested_cubes.msh",
                    "tet/paper_roll.vtk", "tet/polyfem-data_coarse_P4.msh", "tet/sphere3.msh.gz",
                    "tet/test_tets.msh", "periodic/gmsh_CubePeriodic.msh",
                    "periodic/gmsh_periodic_translate_v41.msh", "periodic/gmsh_t18_v41.msh",
                    "periodic/smile_tet_mesh.msh", "periodic/unit_cell.msh"),
    [](const auto& file) {
      std::string name = fs::path(file.param).filename().string();
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace multimesh::test
