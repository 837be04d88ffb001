// SPDX-License-Identifier: BSD-3-Clause
// Tiles that others have made: glued, or refused for the right reason; then ten thousand random operations.
#include <gtest/gtest.h>

#include <filesystem>

#include "adapters/io/simplex_reader.hpp"
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

class PeriodicFile : public testing::TestWithParam<File> {};

TEST_P(PeriodicFile, IsGluedAndSurvivesAStorm) {
  const auto path = std::filesystem::path(MULTIMESH_SHARED_DATA) / "periodic" / GetParam().name;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing";
  const io::SimplexSoup soup = io::read_simplices(path);
  const int d = soup.dimension();
  PeriodicTile tile{
      soup.points,
      {d, static_cast<Index>(soup.points.size()), soup.simplices[static_cast<std::size_t>(d)].corners}};
  PeriodicOptions options = GetParam().options;
  if (GetParam().use_pairs)
    for (const auto& p : soup.periodic)
      options.pairs.insert(options.pairs.end(), p.points.begin(), p.points.end());

  PeriodicDomain domain(tile, options);
  const PeriodicReport& r = domain.report();
  std::cout << GetParam().name << (options.pairs.empty() ? "" : " by its pairs") << ": ";
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
    for (const long x : b) std::cout << x << (&x == &b.back() ? ")" : " ");
  }
  std::cout << std::endl;
  const unsigned seed = 11;
  PeriodicStorm storm(domain, seed, true);
  for (int i = 1; storm.done < 10000 && i <= 60000; ++i) {
    storm.step();
    if (i % 500 == 0) ASSERT_EQ(storm.fault(), "") << "step " << i << ", seed " << seed;
  }
  ASSERT_EQ(storm.fault(), "");
  std::size_t m = 0;
  for (const NodeId n : domain.tree().nodes()) EXPECT_EQ(betti(domain.tree().mesh(n)), at_start[m++]);
  EXPECT_GE(storm.done, 10000U);
  std::cout << "  " << storm.done << " done, " << storm.refused
            << " refused; moved with 1/2/4/8 copies: " << storm.moved_with_copies[1] << '/'
            << storm.moved_with_copies[2] << '/' << storm.moved_with_copies[4] << '/'
            << storm.moved_with_copies[8] << "; mismatch " << domain.mismatch() << std::endl;
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicFile,
                         testing::Values(File{"gmsh_CubePeriodic.msh", along(true, true, true)},
                                         File{"gmsh_CubePeriodic_v41.msh", along(true, true, true), true},
                                         File{"gmsh_periodic_translate.msh", along(true, true, true, true)},
                                         File{"smile_tet_mesh.msh", along(true, true, true)},
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
                           return s + (i.param.use_pairs ? "_pairs" : "");
                         });

}  // namespace
}  // namespace multimesh::test
