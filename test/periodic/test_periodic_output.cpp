// SPDX-License-Identifier: BSD-3-Clause
// A tile after operations is written with its periods, pairs, regions and sources, and glued again.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "multimesh/files/tile_file.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/periodic_storm.hpp"
#include "test/periodic/recut.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

PeriodicDomain read_again(const std::filesystem::path& path) {
  const files::TileFile file = files::read_tile(path);
  return PeriodicDomain(file.tile, file.options);
}

/// Whether each period of one lattice is a vector of the other one, and the other way round.
void expect_same_lattice(const Lattice& a, const Lattice& b) {
  for (const auto& [one, other] : {std::pair{&a, &b}, {&b, &a}})
    for (int axis = 0; axis < 3; ++axis) {
      LatticeVector unit{};
      unit[static_cast<std::size_t>(axis)] = 1;
      EXPECT_TRUE(!one->is_periodic(axis) || other->nearest(one->shift(unit), 1e-9)) << "xyz"[axis];
    }
}

void expect_same(const PeriodicDomain& a, const PeriodicDomain& b) {
  EXPECT_EQ(a.report().euler, b.report().euler);
  EXPECT_LE(b.report().largest_shift, 1e-15);
  EXPECT_EQ(b.report().inverted_facets, 0U);
  const Mesh &one = a.tree().mesh(NodeId::root), &other = b.tree().mesh(NodeId::root);
  std::size_t live = 0;
  for (Index f = 0; f < one.capacity(one.dimension()); ++f) live += one.is_live(one.dimension(), f);
  EXPECT_EQ(live, other.capacity(other.dimension()));
  EXPECT_EQ(validate(b.tree()), std::vector<std::string>{});
  expect_same_lattice(a.lattice(), b.lattice());
  const auto before = sizes(a), after = sizes(b);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [region, size] : before) EXPECT_NEAR(after.at(region), size, 1e-12) << region;
}

/// Of a file, for as long as it lives.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               ("multimesh_periodic_" + std::to_string(std::random_device()()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

class PeriodicOutput : public testing::TestWithParam<std::tuple<int, Recut>> {
 protected:
  /// A torus that was cut up, in regions 3 and 8.
  static RecutTorus torus(unsigned seed) {
    std::mt19937 random(seed);
    const auto [d, how] = GetParam();
    RecutTorus t = recut_torus(d, 4, how, random);
    for (std::size_t f = 0; f < t.tile.facets.size(); ++f) t.tile.regions.push_back(random() % 4 ? 8 : 3);
    t.options.interfaces = true;
    return t;
  }
  Folder folder_;
};

TEST_P(PeriodicOutput, IsReadAgainAfterAStorm) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RecutTorus input = torus(seed);
    PeriodicDomain domain(input.tile, input.options);
    ASSERT_TRUE(domain.listed(input.tile.facets.dimension - 1));
    PeriodicStorm storm(domain, seed, true);
    for (int i = 0; i < 500; ++i) storm.step();
    for (const auto version : {io::MshVersion::v2_2, io::MshVersion::v4_1})
      for (const bool binary : {false, true}) {
        const auto path = folder_.path / "tile.msh";
        EXPECT_EQ(files::write_tile(path, domain, {}, {version, binary}), std::vector<std::string>{});
        expect_same(domain, read_again(path));
      }
  }
}

TEST_P(PeriodicOutput, IsGluedAgainInMemory) {
  const RecutTorus input = torus(7);
  PeriodicDomain domain(input.tile, input.options);
  PeriodicStorm storm(domain, 7, true);
  for (int i = 0; i < 500; ++i) storm.step();
  expect_same(domain, PeriodicDomain(domain.tile_lists(), domain.gluing()));
}

// Some faces, edges and points of the tile, wherever they are; each copy has its own tag.
TEST_P(PeriodicOutput, HasWhatIsListedAfterAStorm) {
  RecutTorus input = torus(13);
  std::mt19937 random(13);
  std::array<std::set<std::set<Index>>, 3> listed;
  for (std::size_t f = 0; f < input.tile.facets.size(); ++f) {
    const auto corners = input.tile.facets.facet(f);
    const auto k = random() % (corners.size() - 1);
    const std::set<Index> simplex(corners.begin(), corners.begin() + static_cast<long>(k) + 1);
    if (random() % 3 || !listed[k].insert(simplex).second) continue;
    auto& list = input.tile.listed[k];
    list.simplices.corners.insert(list.simplices.corners.end(), simplex.begin(), simplex.end());
    list.tags.push_back(static_cast<PeriodicTile::Region>(random() % 5));
  }
  PeriodicDomain domain(input.tile, input.options);
  EXPECT_EQ(domain.report().missing_listed, 0U);
  PeriodicStorm storm(domain, 5, true);
  for (int i = 0; i < 500; ++i) storm.step();
  EXPECT_EQ(storm.fault(), "");
  const PeriodicTile now = domain.tile_lists();
  const PeriodicDomain again(now, domain.gluing());
  EXPECT_EQ(again.report().missing_listed, 0U);
  const auto tags = [](const PeriodicTile& tile, std::size_t k) {
    return std::set(tile.listed[k].tags.begin(), tile.listed[k].tags.end());
  };
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(tags(now, k), tags(input.tile, k)) << k;
    EXPECT_EQ(again.tile_lists().listed[k].tags.size(), now.listed[k].tags.size()) << k;
  }
  EXPECT_EQ(now.listed[0].tags.size(), input.tile.listed[0].tags.size());
}

TEST_P(PeriodicOutput, TellsWhereFacetsAndVerticesComeFrom) {
  const RecutTorus input = torus(9);
  PeriodicDomain domain(input.tile, input.options);
  ASSERT_TRUE(domain.listed(input.tile.facets.dimension - 1));
  PeriodicStorm storm(domain, 3, true);
  for (int i = 0; i < 300; ++i) storm.step();
  const PeriodicTile now = domain.tile_lists();
  const PeriodicSources sources = domain.sources();
  ASSERT_EQ(sources.facets.size(), now.facets.size());
  ASSERT_EQ(sources.vertices.size(), now.points.size());
  ASSERT_EQ(now.regions.size(), now.facets.size());
  for (std::size_t f = 0; f < now.facets.size(); ++f) {
    ASSERT_LT(sources.facets[f], input.tile.facets.size());
    EXPECT_EQ(now.regions[f], input.tile.regions[sources.facets[f]]);
  }
  std::map<Index, int> seen, at_first;  // more than once where the tile was cut
  for (const Index v : domain.input_vertices()) ++at_first[v];
  for (const Index v : sources.vertices)
    if (v != no_index) {
      EXPECT_LE(++seen[v], at_first[v]) << "vertex " << v;
    }
  EXPECT_FALSE(seen.empty());
  EXPECT_LT(seen.size(), sources.vertices.size());
}

TEST_P(PeriodicOutput, SidesCoverWhatIsGlued) {
  const RecutTorus input = torus(11);
  PeriodicDomain domain(input.tile, input.options);
  std::size_t faces = 0;
  const PeriodicTile tile = domain.tile_lists();
  for (const PeriodicSide& side : domain.sides()) {
    faces += 2 * side.master.size();
    ASSERT_EQ(side.master.corners.size(), side.slave.corners.size());
    const Vec3 shift = domain.lattice().shift(side.shift);
    for (std::size_t i = 0; i < side.master.corners.size(); ++i) {
      const Vec3 m(tile.points[side.master.corners[i]]), s(tile.points[side.slave.corners[i]]);
      EXPECT_LE((s - m - shift).norm(), 1e-14);
    }
  }
  const auto cuts = domain.add_cuts();
  ASSERT_TRUE(cuts);
  const Mesh& mesh = domain.tree().mesh(*cuts);
  EXPECT_EQ(faces, mesh.capacity(mesh.dimension()));
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicOutput,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Recut::rows, Recut::blocks, Recut::plane)));

TEST(PeriodicBox, IsReadAgainAfterACornerMoved) {
  PeriodicTile tile = cube_tile(4);
  tile.regions.assign(tile.facets.size(), 1);  // Gmsh's files have no region 0
  PeriodicDomain domain(tile, along(true, true, true));
  Propagation propagation(domain.tree());
  domain.attach(propagation);
  const Dart corner = domain.tree().mesh(domain.tile()).dart_of(0, 0);
  ASSERT_TRUE(domain.move(propagation, domain.tile(), corner, {0.03, 0.02, 0.01}));
  const Folder folder;
  files::write_tile(folder.path / "tile.msh", domain);
  expect_same(domain, read_again(folder.path / "tile.msh"));
}

TEST(LatticeBasis, GeneratesWhatItWasGiven) {
  std::mt19937 random(4);
  const auto integer = [&] { return double(random() % 7) - 3; };
  for (int i = 0; i < 300; ++i) {
    const int rank = 1 + i % 3;
    Eigen::Matrix3d periods = Eigen::Matrix3d::Zero();
    for (int k = 0; k < rank; ++k)
      periods.col(k) = Eigen::Vector3d::Unit(k) + 0.3 * Eigen::Vector3d::Random();
    // Many combinations, so that they generate all of it; none of them need be short.
    std::vector<Vec3> given;
    for (int n = 0; n < 12; ++n) {
      Eigen::Vector3d c = Eigen::Vector3d::Zero();
      for (int k = 0; k < rank; ++k) c[k] = integer();
      const Eigen::Vector3d v = periods * c + 1e-12 * Eigen::Vector3d::Random();
      given.push_back({v[0], v[1], v[2]});
    }
    for (int k = 0; k < rank; ++k) {
      given.push_back(given[static_cast<std::size_t>(k)] + Vec3(periods(0, k), periods(1, k), periods(2, k)));
      given.push_back(given[static_cast<std::size_t>(k)]);
    }
    const auto basis = lattice_basis(given, 1e-6);
    ASSERT_EQ(basis.size(), static_cast<std::size_t>(rank));
    Eigen::Matrix3d b = Eigen::Matrix3d::Zero();
    std::array<bool, 3> on{};
    for (std::size_t k = 0; k < basis.size(); ++k)
      b.col(static_cast<Eigen::Index>(k)) = Eigen::Vector3d(basis[k].data()), on[k] = true;
    expect_same_lattice(Lattice(on, b), Lattice(on, periods));
  }
}

TEST(LatticeBasis, KeepsVectorsThatWillDo) {
  const std::vector<Vec3> given{{0, 0, 1}, {1, 0, 0}, {0.25, 1, 0}, {1.25, 1, 0}};
  const PeriodicOptions options = options_of_pairs(
      {{0, 1}}, std::vector<std::array<double, 3>>{{0, 0, -1}, {1, 0, 0}, {0.25, 1, 0}, {1.25, 1, 0}});
  EXPECT_EQ(lattice_basis(given, 1e-9).size(), 3U);
  EXPECT_EQ(options.periods, (std::array<std::array<double, 3>, 3>{{{1, 0, 0}, {0.25, 1, 0}, {0, 0, 1}}}));
  EXPECT_THROW(options_of_pairs({}, {}), InputError);
}

}  // namespace
}  // namespace multimesh::test
