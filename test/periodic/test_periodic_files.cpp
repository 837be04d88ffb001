// SPDX-License-Identifier: BSD-3-Clause
// Tiles made by others: glued, or refused for the right reason; then ten thousand random operations.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/periodic_storm.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

struct File {
  const char* name;
  PeriodicOptions options;
  bool use_pairs = false;
  friend void PrintTo(const File& f, std::ostream* out) { *out << f.name; }
};

struct Content {
  PeriodicTile tile;
  std::vector<std::array<Index, 2>> pairs;
};

std::optional<Content> read(const std::string& name, const char* folder = "periodic") {
  const auto path = std::filesystem::path(MULTIMESH_SHARED_DATA) / folder / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  const io::SimplexSoup soup = io::read_simplices(path);
  const int d = soup.dimension();
  const auto& corners = soup.simplices[static_cast<std::size_t>(d)].corners;
  Content c{{soup.points, {d, static_cast<Index>(soup.points.size()), corners}}, {}};
  for (const auto& p : soup.periodic) c.pairs.insert(c.pairs.end(), p.points.begin(), p.points.end());
  return c;
}

/// How many operations are to be done on each file: MULTIMESH_STORM, or few.
std::size_t storm_length() {
  const char* given = std::getenv("MULTIMESH_STORM");
  return given ? std::strtoul(given, nullptr, 10) : 1500;
}

/// Two unit cubes side by side, the second one periodic along x only.
PeriodicOptions unit_cubes() {
  PeriodicOptions o;
  o.periods = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return o;
}

class PeriodicFile : public testing::TestWithParam<File> {};

TEST_P(PeriodicFile, IsGluedAndSurvivesAStorm) {
  const auto file = read(GetParam().name);
  if (!file) GTEST_SKIP() << GetParam().name << " is missing";
  PeriodicOptions options = GetParam().options;
  if (GetParam().use_pairs) options.pairs = file->pairs;

  PeriodicDomain domain(file->tile, options);
  const PeriodicReport& r = domain.report();
  std::cout << GetParam().name << (options.pairs.empty() ? "" : " by its pairs") << ": ";
  const int d = file->tile.facets.dimension;
  for (int k = 0; k <= d; ++k) std::cout << r.simplices[static_cast<std::size_t>(k)] << (k < d ? "/" : "");
  std::cout << ", chi " << r.euler << ", copies";
  for (std::size_t n = 1; n < r.with_copies.size(); ++n)
    if (r.with_copies[n] > 0) std::cout << ' ' << n << ':' << r.with_copies[n];
  std::cout << ", shift " << r.largest_shift << ", split " << r.split_edges << " (+" << r.added_facets
            << "), cut " << r.cut_vertices << '/' << r.cut_root_vertices << ", reversed " << r.reversed_facets
            << ", inverted " << r.inverted_facets << std::endl;
  ASSERT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_EQ(r.inverted_facets, 0U);

  domain.add_surface();
  std::vector<std::vector<long>> at_start;
  for (const NodeId n : domain.tree().nodes()) at_start.push_back(betti(domain.tree().mesh(n)));
  std::cout << "  betti";
  for (const auto& b : at_start) {
    std::cout << " (";
    for (const long& x : b) std::cout << x << (&x == &b.back() ? ")" : " ");
  }
  std::cout << std::endl;
  const unsigned seed = 11;
  PeriodicStorm storm(domain, seed, true);
  const std::size_t wanted = storm_length();
  for (std::size_t i = 1; storm.done < wanted && i <= 12 * wanted; ++i) {
    storm.step();
    if (i % 100 == 0) {
      ASSERT_EQ(storm.fault(), "") << "step " << i << ", seed " << seed;
    }
  }
  ASSERT_EQ(storm.fault(), "");
  std::size_t m = 0;
  for (const NodeId n : domain.tree().nodes()) EXPECT_EQ(betti(domain.tree().mesh(n)), at_start[m++]);
  EXPECT_GE(storm.done, wanted);
  std::cout << "  " << storm.done << " done, " << storm.refused
            << " refused; moved with 1/2/4/8 copies: " << storm.moved_with_copies[1] << '/'
            << storm.moved_with_copies[2] << '/' << storm.moved_with_copies[4] << '/'
            << storm.moved_with_copies[8] << "; mismatch " << domain.mismatch() << std::endl;
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicFile,
                         testing::Values(File{"gmsh_CubePeriodic.msh", along(true, true, true)},
                                         File{"gmsh_CubePeriodic_v41.msh", along(true, true, true), true},
                                         File{"gmsh_periodic_translate.msh", along(true, true, true, true)},
                                         File{"smile_tet_mesh.msh", along(true, true, false)},
                                         File{"smile_tet_mesh.msh", along(true, true, true, true)},
                                         File{"gmsh_t18_v41.msh", unit_cubes(), true},
                                         File{"unit_cell.msh", along(true, true, true, true)},
                                         File{"unit_cell.msh", along(true, true, true, true), true},
                                         File{"gmsh_simple_periodic_2d.msh", along(true, true, false)},
                                         File{"gmsh_simple_periodic_2d_v41.msh", along(true, true, false),
                                              true},
                                         File{"2D_microstructure.msh", along(true, true, false)},
                                         File{"FreeFem_ThS.mesh", along(true, false, true)},
                                         File{"plate4SD.ply", along(true, true, false)},
                                         File{"square_hole.off", along(true, true, false)}),
                         [](const auto& i) {
                           std::string s = i.param.name;
                           for (char& c : s)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return s + (i.param.use_pairs ? "_pairs" : "") +
                                  (i.param.options.refine ? "_refined" : "");
                         });

TEST(PeriodicFileRefused, ForTheRightReason) {
  const struct {
    const char* name;
    PeriodicOptions options;
    const char* reason;
  } cases[] = {
      // One layer of cubes thick: two edges, of different lengths, lead through it.
      {"smile_tet_mesh.msh", along(true, true, true), "along z; at least 3 are needed"},
      {"wire_cube.obj", along(true, true, true), "has dimension 2 or 3, not 1"},
      // Two cubes side by side, the sides of the box are those of different ones.
      {"gmsh_t18_v41.msh", along(true, true, true), "along x do not match: vertex"},
  };
  for (const auto& c : cases) {
    const auto file = read(c.name);
    if (!file) GTEST_SKIP() << c.name << " is missing";
    const std::string why = refusal(file->tile, c.options);
    EXPECT_NE(why.find(c.reason), std::string::npos) << c.name << ": " << why;
  }
}

/// Tiles with all the ways in which sides can meet; the numbers were found by a program of another author.
TEST(PeriodicTiles, AreGluedAsTheyShould) {
  using Vectors = std::array<std::array<double, 3>, 3>;
  const Vectors unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<bool, 3> xy{true, true, false}, xyz{true, true, true};
  const struct {
    const char* name;
    std::array<bool, 3> axes;
    std::optional<Vectors> periods;
    std::size_t vertices, facets;
    long euler;
  } tiles[] = {
      {"bcc_struts.msh.gz", xyz, {}, 1618, 4824, -6},
      {"brick_bond_2d.msh.gz", xy, Vectors{{{1, 0, 0}, {0.5, 0.6, 0}, {}}}, 240, 480, 0},
      {"gyroid_sheet.msh.gz", xyz, {}, 3451, 12756, -8},
      {"gyroid_solid.msh.gz", xyz, {}, 1159, 4038, -4},
      {"hexagon_oblique.msh.gz", xy, Vectors{{{1.7320508075688772, 0, 0}, {0.8660254037844386, 1.5, 0}, {}}},
       192, 384, 0},
      {"jagged_cube.msh.gz", xyz, unit, 216, 1296, 0},
      {"rve2d_coarse_v41.msh.gz", xy, {}, 218, 436, 0},
      {"rve3d_spheres_v41.msh.gz", xyz, {}, 791, 4833, 0},
      {"schwarzp_two_regions.msh.gz", xyz, {}, 1144, 6576, 0},
      {"sfepy_osteonT1_11.msh.gz", xy, {}, 1146, 2292, 0},
      {"slivers_2d.obj.gz", xy, {}, 256, 512, 0},
      {"slivers_2d_curved.obj.gz", xy, unit, 256, 512, 0},
      {"thin_film_xy.msh.gz", xy, {}, 946, 3292, 0},
      {"cube_order2_v41.msh.gz", xyz, {}, 181, 1095, 0},
  };
  for (const auto& t : tiles) {
    SCOPED_TRACE(t.name);
    const auto file = read(t.name, "periodic_tiles");
    if (!file) GTEST_SKIP() << t.name << " is missing";
    PeriodicOptions options;
    options.axes = t.axes;
    options.periods = t.periods;
    PeriodicDomain domain(file->tile, options);
    EXPECT_EQ(domain.report().simplices[0], t.vertices);
    EXPECT_EQ(domain.report().simplices[static_cast<std::size_t>(file->tile.facets.dimension)], t.facets);
    EXPECT_EQ(domain.report().euler, t.euler);
    EXPECT_LE(domain.mismatch(), 1e-15);
  }
  for (const char* name : {"rve3d_t18way_v41.msh.gz", "sfepy_cube_sphere.msh.gz"})
    EXPECT_NE(refusal(read(name, "periodic_tiles")->tile, along(true, true, true)).find("do not match"),
              std::string::npos)
        << name;
}

}  // namespace
}  // namespace multimesh::test
