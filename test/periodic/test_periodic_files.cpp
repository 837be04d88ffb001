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
std::size_t storm_length(std::size_t usual) {
  const char* given = std::getenv("MULTIMESH_STORM");
  return given ? std::strtoul(given, nullptr, 10) : usual;
}

/// Does so many operations, with a look at everything after each hundred tries.
void expect_to_survive(PeriodicDomain& domain, std::size_t wanted) {
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

  expect_to_survive(domain, storm_length(1500));
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

using Vectors = std::array<std::array<double, 3>, 3>;
constexpr Vectors unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<bool, 3> xy{true, true, false}, xyz{true, true, true};

/// Tiles with all the ways in which sides can meet; the numbers were found by a program of another author.
struct Tile {
  const char* name;
  std::array<bool, 3> axes;
  std::optional<Vectors> periods;
  std::size_t vertices, facets;
  long euler;
  friend void PrintTo(const Tile& t, std::ostream* out) { *out << t.name; }
};
const Tile tiles[] = {
    {"bcc_struts", xyz, {}, 1618, 4824, -6},
    {"brick_bond_2d", xy, Vectors{{{1, 0, 0}, {0.5, 0.6, 0}, {}}}, 240, 480, 0},
    {"gyroid_sheet", xyz, {}, 3451, 12756, -8},
    {"gyroid_solid", xyz, {}, 1159, 4038, -4},
    {"hexagon_oblique", xy, Vectors{{{1.7320508075688772, 0, 0}, {0.8660254037844386, 1.5, 0}, {}}}, 192, 384,
     0},
    {"jagged_cube", xyz, unit, 216, 1296, 0},
    {"rve2d_coarse_v22", xy, {}, 218, 436, 0},
    {"rve2d_coarse_v41", xy, {}, 218, 436, 0},
    {"rve3d_spheres_v41", xyz, {}, 791, 4833, 0},
    {"schwarzp_two_regions", xyz, {}, 1144, 6576, 0},
    {"sfepy_osteonT1_11", xy, {}, 1146, 2292, 0},
    {"slivers_2d", xy, {}, 256, 512, 0},
    {"slivers_2d_curved", xy, unit, 256, 512, 0},
    {"thin_film_xy", xy, {}, 946, 3292, 0},
    {"cube_order2_v41", xyz, {}, 181, 1095, 0},
};

std::optional<Content> read_tile(const std::string& name) {
  const auto file = read(name + ".msh.gz", "periodic_tiles");
  return file ? file : read(name + ".obj.gz", "periodic_tiles");
}

class PeriodicTiles : public testing::TestWithParam<Tile> {};

TEST_P(PeriodicTiles, AreGluedAsTheyShouldAndSurviveAStorm) {
  const Tile& t = GetParam();
  const auto file = read_tile(t.name);
  if (!file) GTEST_SKIP() << t.name << " is missing";
  PeriodicOptions options;
  options.axes = t.axes;
  options.periods = t.periods;
  PeriodicDomain domain(file->tile, options);
  EXPECT_EQ(domain.report().simplices[0], t.vertices);
  EXPECT_EQ(domain.report().simplices[static_cast<std::size_t>(file->tile.facets.dimension)], t.facets);
  EXPECT_EQ(domain.report().euler, t.euler);
  EXPECT_LE(domain.mismatch(), 1e-15);
  expect_to_survive(domain, storm_length(300));
}
INSTANTIATE_TEST_SUITE_P(All, PeriodicTiles, testing::ValuesIn(tiles),
                         [](const auto& i) { return std::string(i.param.name); });

TEST(PeriodicTilesRefused, NamingAxisVertexPlaceAndDistance) {
  for (const char* name : {"rve3d_t18way_v41", "sfepy_cube_sphere"}) {
    const auto file = read_tile(name);
    if (!file) GTEST_SKIP() << name << " is missing";
    const std::string why = refusal(file->tile, along(true, true, true));
    for (const char* part :
         {"sides along", "do not match", "vertex", " at (", "the nearest is", "at distance"})
      EXPECT_NE(why.find(part), std::string::npos) << name << ": " << why;
  }
}

}  // namespace
}  // namespace multimesh::test
