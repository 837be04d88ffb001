// SPDX-License-Identifier: BSD-3-Clause
// Periodic tiles: the file declares what is glued.
#include "multimesh/files/tile_file.hpp"
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
  EXPECT_EQ(file.groups.groups.size(), 2U);
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

TEST_F(Tile, TellsOfWhatItLeavesOut) {
  const PeriodicDomain domain(two_regions(), along(true, true, true));
  write_tile(folder / "t.msh", domain);  // with the triangles of its sides
  EXPECT_TRUE(any_has(read_tile(folder / "t.msh").warnings, "triangles are left out"));
}

TEST_F(Tile, OfCurvesIsRefused) {
  const auto path = write("t.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const std::string why = refusal([&] { read_tile(path); });
  EXPECT_NE(why.find("t.obj: has no tetrahedra and no triangles"), std::string::npos) << why;
}

}  // namespace
}  // namespace multimesh::files::test
