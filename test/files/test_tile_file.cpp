// SPDX-License-Identifier: BSD-3-Clause
// Periodic tiles: the file declares what is glued.
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

#include "multimesh/files/tile_file.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"
#include "test/files/folder.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::files::test {
namespace {

using multimesh::test::along;
using multimesh::test::cube_tile;

class Tile : public InFolder {
 protected:
  static PeriodicTile two_regions() {
    PeriodicTile tile = cube_tile(4);
    for (std::size_t f = 0; f < tile.facets.size(); ++f) tile.regions.push_back(f % 3 == 0 ? 2 : 7);
    return tile;
  }
};

TEST_F(Tile, IsGluedAgainByThePairsOfItsFile) {
  const PeriodicDomain domain(two_regions(), along(true, true, true));
  EXPECT_EQ(write_tile(folder / "t.msh", domain, {{{3, 2, "matrix"}, {3, 7, "fibre"}}, {}}),
            std::vector<std::string>{});
  const TileFile file = read_tile(folder / "t.msh");
  EXPECT_FALSE(file.options.pairs.empty());
  EXPECT_EQ(std::ranges::count(file.tile.regions, 2), std::ranges::count(two_regions().regions, 2));
  EXPECT_EQ(std::ranges::count(file.groups.groups, 3, &io::SimplexSoup::Group::dimension), 2);
  const PeriodicDomain again(file.tile, file.options);
  EXPECT_EQ(again.report().simplices, domain.report().simplices);
  EXPECT_EQ(validate(again.tree()), std::vector<std::string>{});
}

TEST_F(Tile, IsMatchedByItsSidesWhereTheFileSaysNothing) {
  const PeriodicDomain domain(two_regions(), along(true, true, true));
  EXPECT_TRUE(any_has(write_tile(folder / "t.vtu", domain), "periodic links are not written"));
  const TileFile file = read_tile(folder / "t.vtu");
  EXPECT_TRUE(file.options.pairs.empty());
  EXPECT_EQ(PeriodicDomain(file.tile, file.options).report().simplices, domain.report().simplices);
}

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A copy of a listed simplex, by its places, with its tag.
using Placed = std::pair<std::set<std::array<double, 3>>, PeriodicTile::Region>;

std::multiset<Placed> placed(const PeriodicTile& tile, std::size_t k) {
  std::multiset<Placed> all;
  for (std::size_t s = 0; s < tile.listed[k].tags.size(); ++s) {
    Placed one{{}, tile.listed[k].tags[s]};
    for (const Index v : tile.listed[k].simplices.facet(s)) one.first.insert(tile.points[v]);
    all.insert(one);
  }
  return all;
}

/// A cube that lists its sides, each with a tag of its own, a face in the middle in two parts, edges of the
/// box, and a point.
PeriodicTile listing_cube() {
  PeriodicTile tile = cube_tile(4);
  tile.regions.assign(tile.facets.size(), 1);
  std::map<std::set<Index>, int> times;
  const auto faces = [&](auto visit) {
    for (std::size_t t = 0; t < tile.facets.size(); ++t)
      for (std::size_t i = 0; i < 4; ++i) {
        std::set<Index> face;
        for (std::size_t j = 0; j < 4; ++j)
          if (j != i) face.insert(tile.facets.facet(t)[j]);
        visit(face);
      }
  };
  const auto lies_at = [&](const std::set<Index>& face, std::size_t axis, double x) {
    return std::ranges::all_of(face, [&](Index v) { return tile.points[v][axis] == x; });
  };
  const auto list = [&](const std::set<Index>& simplex, PeriodicTile::Region tag) {
    auto& listed = tile.listed[simplex.size() - 1];
    listed.simplices.corners.insert(listed.simplices.corners.end(), simplex.begin(), simplex.end());
    listed.tags.push_back(tag);
  };
  faces([&](const auto& face) { ++times[face]; });
  for (const auto& [face, n] : times) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int end : {0, 1})
        if (lies_at(face, axis, end)) list(face, static_cast<PeriodicTile::Region>(10 + 2 * axis) + end);
    if (lies_at(face, 2, 0.5)) list(face, tile.points[*face.begin()][0] < 0.5 ? 30 : 31);
  }
  for (Index k = 0; k < 4; ++k) {
    list({k, k + 1}, 40);                  // along z at x = y = 0
    list({k + 5 * 4, k + 1 + 5 * 4}, 41);  // its copy at y = 1; those at x = 1 are not listed
  }
  list({2 * 25 + 2 * 5 + 1}, 50);
  return tile;
}

TEST_F(Tile, KeepsWhatItListsOnEachOfItsSides) {
  const PeriodicTile tile = listing_cube();
  PeriodicDomain domain(tile, along(true, true, true));
  EXPECT_EQ(domain.report().missing_listed, 0U);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  const DomainGroups groups{{{2, 10, "left"}, {2, 11, "right"}, {1, 40, "axis"}, {0, 50, "point"}}, {}};
  for (const auto version : {io::MshVersion::v2_2, io::MshVersion::v4_1}) {
    EXPECT_EQ(write_tile(folder / "t.msh", domain, groups, {version, true}), (std::vector<std::string>{}));
    const TileFile file = read_tile(folder / "t.msh");
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(placed(file.tile, k), placed(tile, k)) << k;
    for (const auto& g : groups.groups) EXPECT_EQ(std::ranges::count(file.groups.groups, g), 1) << g.name;
  }
}

TEST_F(Tile, KeepsTagsOfHalvesAfterSplits) {
  PeriodicDomain domain(listing_cube(), along(true, true, true));
  Propagation propagation(domain.tree());
  domain.attach(propagation);
  const Mesh& tile = domain.tree().mesh(domain.tile());
  for (int round = 0; round < 40; ++round) {
    const Dart e = tile.dart_of(3, static_cast<Index>(37 * round) % tile.capacity(3));
    ASSERT_TRUE(propagation.split(domain.tile(), e));
  }
  std::map<PeriodicTile::Region, double> area;
  const PeriodicTile now = domain.tile_lists();
  for (std::size_t s = 0; s < now.listed[2].tags.size(); ++s) {
    Vec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = Vec3(now.points[now.listed[2].simplices.facet(s)[i]]);
    area[now.listed[2].tags[s]] += cross(p[1] - p[0], p[2] - p[0]).norm() / 2;
  }
  for (PeriodicTile::Region tag = 10; tag < 16; ++tag) EXPECT_NEAR(area[tag], 1, 1e-12) << tag;
  EXPECT_NEAR(area[30] + area[31], 1, 1e-12);
}

/// The points of a cube written in this order, also those in the middles of edges, which are read as unused.
std::vector<std::array<double, 3>> points_written(const PeriodicDomain& domain,
                                                  const std::filesystem::path& path, int order) {
  write_tile(path, domain, {}, {.order = order});
  return io::read_simplices(path).points;
}

/// Of a cube of 4^3 cubes, each cut along its diagonals: the middles of edges are the points of 8^3 cubes.
std::size_t points_per_edge(int order) {
  return order == 1 ? 5 : 9;
}
std::size_t copies_of_cube(int order) {
  const std::size_t n = points_per_edge(order);
  return n * n * n - (n - 1) * (n - 1) * (n - 1);
}

class TileOfOrder : public Tile, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, TileOfOrder, testing::Values(1, 2));

TEST_P(TileOfOrder, TablesNameEachSlaveOnceAndItsMasterLatticeVectorsAway) {
  const PeriodicDomain domain(cube_tile(4), along(true, true, true));
  write_pair_table(folder / "t.csv", domain, GetParam());
  const auto points = points_written(domain, folder / "t.msh", GetParam());
  EXPECT_EQ(points.size(), std::pow(points_per_edge(GetParam()), 3));
  std::istringstream lines(content(folder / "t.csv"));
  std::string line;
  std::set<int> slaves, masters;
  std::map<int, int> of_master;
  int comments = 0;
  for (bool header = false; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      ++comments;
    } else if (!std::exchange(header, true)) {
      EXPECT_EQ(line, "slave,master,kx,ky,kz");
    } else {
      int n[5];
      ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d,%d,%d", n, n + 1, n + 2, n + 3, n + 4), 5) << line;
      EXPECT_TRUE(slaves.insert(n[0]).second) << line;
      masters.insert(n[1]);
      ++of_master[n[1]];
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(points.at(static_cast<std::size_t>(n[0] - 1))[i],
                  points.at(static_cast<std::size_t>(n[1] - 1))[i] + n[2 + i]);
    }
  }
  EXPECT_EQ(comments, 3);
  EXPECT_EQ(slaves.size(), copies_of_cube(GetParam()));
  for (const int m : masters) EXPECT_FALSE(slaves.contains(m));
  EXPECT_EQ(std::ranges::count_if(of_master, [](const auto& m) { return m.second == 7; }), 1);  // the corner
}

TEST_P(TileOfOrder, EquationsHoldForAnyAffineDisplacement) {
  const PeriodicDomain domain(cube_tile(4), along(true, true, true));
  write_abaqus_equations(folder / "t.inp", domain, GetParam());
  const auto points = points_written(domain, folder / "t.msh", GetParam());
  const auto n = points.size();
  // The displacement of a reference node is that of its period: the gradient times the vector.
  const double gradient[3][3] = {{2, 3, 5}, {7, 11, 13}, {17, 19, 23}};
  const auto displacement = [&](std::size_t node, std::size_t degree) {
    if (node > n) return gradient[degree][node - n - 1];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += gradient[degree][i] * points[node - 1][i];
    return sum;
  };
  std::istringstream in(content(folder / "t.inp"));
  std::string line;
  std::size_t equations = 0;
  while (std::getline(in, line)) {
    if (line != "*EQUATION") continue;
    std::size_t terms = 0;
    ASSERT_TRUE(std::getline(in, line));
    terms = std::stoul(line);
    double sum = 0;
    while (terms > 0) {
      ASSERT_TRUE(std::getline(in, line));
      std::ranges::replace(line, ',', ' ');
      std::istringstream numbers(line);
      std::size_t in_line = 0, node = 0, degree = 0;
      for (double factor = 0; numbers >> node >> degree >> factor; ++in_line, --terms)
        sum += factor * displacement(node, degree - 1);
      ASSERT_LE(in_line, 4U) << line;
      ASSERT_GE(in_line, 1U) << line;
    }
    EXPECT_NEAR(sum, 0, 1e-12);
    ++equations;
  }
  EXPECT_EQ(equations, 3 * copies_of_cube(GetParam()));
}

/// The order of a triangle's nodes would show if it were wrong: it is read again corner by corner.
TEST_F(Tile, OfSecondOrderIsReadAsOneOfFirstOrder) {
  PeriodicDomain domain(listing_cube(), along(true, true, true));
  for (const char* name : {"t.msh", "t.vtu"})
    for (const bool binary : {true, false})
      for (const auto version : {io::MshVersion::v2_2, io::MshVersion::v4_1}) {
        write_tile(folder / "first.msh", domain);
        write_tile(folder / name, domain, {}, {version, binary, 2});
        const TileFile first = read_tile(folder / "first.msh"), second = read_tile(folder / name);
        EXPECT_EQ(second.tile.points, first.tile.points);
        EXPECT_EQ(second.tile.facets.corners, first.tile.facets.corners);
        EXPECT_EQ(second.options.pairs,
                  std::string(name) == "t.msh" ? first.options.pairs : decltype(first.options.pairs){});
        EXPECT_TRUE(any_has(second.warnings, "higher order"));
      }
  for (const char* name : {"t.mesh", "t.obj"}) {
    const std::string why = refusal([&] { write_tile(folder / name, domain, {}, {.order = 2}); });
    EXPECT_NE(why.find("only written to .msh and .vtu"), std::string::npos) << why;
  }
}

TEST_F(Tile, OfSecondOrderHasLinksBetweenAllMiddlesInItsSides) {
  const PeriodicDomain domain(cube_tile(4), along(true, true, true));
  const auto points = points_written(domain, folder / "t.msh", 2);
  const io::SimplexSoup soup = io::read_simplices(folder / "t.msh");
  ASSERT_EQ(soup.periodic.size(), 3U);
  for (const auto& link : soup.periodic) {
    EXPECT_EQ(link.points.size(), 81U);
    for (const auto& [slave, master] : link.points)
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(points[slave][i], points[master][i] + link.affine[4 * i + 3]);
  }
}

TEST_F(Tile, OfCurvesIsRefused) {
  const auto path = write("t.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const std::string why = refusal([&] { read_tile(path); });
  EXPECT_NE(why.find("t.obj: has no tetrahedra and no triangles"), std::string::npos) << why;
}

}  // namespace
}  // namespace multimesh::files::test
