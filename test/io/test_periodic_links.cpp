// SPDX-License-Identifier: BSD-3-Clause
// $Periodic: written and read again in all forms, as Gmsh and meshio read it.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "adapters/io/periodic_links.hpp"
#include "multimesh/error.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

/// A unit cube in n^3 cubes of six tetrahedra, in two regions, sheared if `shear` is not 0; no triangle is
/// listed.
SimplexSoup cube(std::uint32_t n, double shear = 0) {
  SimplexSoup soup;
  const auto at = [n](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return (i * (n + 1) + j) * (n + 1) + k;
  };
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t k = 0; k <= n; ++k)
        soup.points.push_back({(i + shear * j) / double(n), j / double(n), k / double(n)});
  std::array<std::uint32_t, 3> order{0, 1, 2};
  do {
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t k = 0; k < n; ++k) {
          std::array<std::uint32_t, 3> p{i, j, k};
          soup.simplices[3].corners.push_back(at(i, j, k));
          for (const std::uint32_t axis : order) {
            ++p[axis];
            soup.simplices[3].corners.push_back(at(p[0], p[1], p[2]));
          }
          soup.simplices[3].tags.push_back(2 * i < n ? 1 : 2);
        }
  } while (std::next_permutation(order.begin(), order.end()));
  return soup;
}

/// The triangles of the side of a cube at which `axis` is 0, and those at which it is 1.
PeriodicFaces side(const SimplexSoup& soup, std::size_t axis, double shear = 0) {
  PeriodicFaces faces{std::string(1, "xyz"[axis]), {}, {}, {}};
  faces.translation[axis] = 1;
  if (axis == 1) faces.translation[0] = shear;
  std::map<std::array<double, 3>, std::uint32_t> at;
  const auto rounded = [](std::array<double, 3> p) {
    for (double& x : p) x = std::round(1e6 * x);
    return p;
  };
  for (std::uint32_t v = 0; v < soup.points.size(); ++v) at[rounded(soup.points[v])] = v;
  const auto coordinate = [&](std::uint32_t v) {
    return soup.points[v][axis] - (axis == 0 ? shear * soup.points[v][1] : 0);
  };
  std::set<std::vector<std::uint32_t>> done;
  for (std::size_t t = 0; t < soup.simplices[3].size(); ++t) {
    std::vector<std::uint32_t> corners;
    for (std::size_t c = 0; c < 4; ++c)
      if (const auto v = soup.simplices[3].corners[4 * t + c]; std::abs(coordinate(v)) < 1e-9)
        corners.push_back(v);
    std::sort(corners.begin(), corners.end());
    if (corners.size() != 3 || !done.insert(corners).second) continue;
    for (const std::uint32_t v : corners) {
      auto p = soup.points[v];
      for (std::size_t i = 0; i < 3; ++i) p[i] += faces.translation[i];
      faces.master.push_back(v);
      faces.slave.push_back(at.at(rounded(p)));
    }
  }
  return faces;
}

SimplexSoup periodic_cube(double shear = 0) {
  SimplexSoup soup = cube(3, shear);
  add_periodic_faces(soup, 2, {side(soup, 0, shear), side(soup, 1, shear), side(soup, 2, shear)});
  return soup;
}

using PeriodicLinks = IoTest;

TEST_F(PeriodicLinks, AreWrittenAndReadAgain) {
  for (const double shear : {0.0, 0.3})
    for (const Form& form : volume_forms) {
      if (!form.name.ends_with(".msh")) continue;
      SCOPED_TRACE(form.name);
      const SimplexSoup soup = periodic_cube(shear);
      EXPECT_EQ(write_simplices(directory / form.name, soup, form.options), std::vector<std::string>{});
      const SimplexSoup again = read_simplices(directory / form.name);
      expect_same_simplices(soup, again);
      EXPECT_EQ(again.groups, soup.groups);
      EXPECT_EQ(again.periodic, soup.periodic);
      const PeriodicPairs pairs = periodic_pairs(again);
      EXPECT_EQ(pairs.translations,
                (std::vector<std::array<double, 3>>{{1, 0, 0}, {shear, 1, 0}, {0, 0, 1}}));
      EXPECT_EQ(pairs.pairs.size(), 3U * 16U);
    }
}

TEST_F(PeriodicLinks, NameEntitiesThatAreThere) {
  SimplexSoup soup = periodic_cube();
  soup.simplices[2].tags[0] = 4;  // of another group than the rest of its side
  soup.groups.push_back({2, 7, "of an entity's number"});
  soup.simplices[2].corners.insert(soup.simplices[2].corners.end(), {21, 22, 26});
  soup.simplices[2].tags.push_back(soup.periodic[0].slave);
  for (const Form& form : volume_forms) {
    if (!form.name.ends_with(".msh")) continue;
    SCOPED_TRACE(form.name);
    write_simplices(directory / form.name, soup, form.options);
    const SimplexSoup again = read_simplices(directory / form.name);
    expect_same_simplices(soup, again);
    EXPECT_EQ(again.periodic, soup.periodic);
  }
}

TEST_F(PeriodicLinks, AreSaidToBeLostInOtherFormats) {
  for (const char* name : {"a.vtu", "a.mesh"}) {
    const auto warnings = write_simplices(directory / name, periodic_cube());
    EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& w) {
      return w.find("periodic links are not written") != std::string::npos;
    })) << name;
  }
}

TEST_F(PeriodicLinks, KeepListedFacesAndTheirTags) {
  SimplexSoup soup = cube(3);
  const PeriodicFaces x = side(soup, 0);
  soup.simplices[2].corners.assign(x.slave.begin(), x.slave.begin() + 6);
  std::swap(soup.simplices[2].corners[0], soup.simplices[2].corners[2]);
  soup.simplices[2].tags = {17, 18};
  const SimplexSoup::Block before = soup.simplices[2];
  add_periodic_faces(soup, 2, {x});
  EXPECT_EQ(soup.simplices[2].size(), 2 * 18U);
  EXPECT_TRUE(std::equal(before.tags.begin(), before.tags.end(), soup.simplices[2].tags.begin()));
  EXPECT_TRUE(std::equal(before.corners.begin(), before.corners.end(), soup.simplices[2].corners.begin()));
  EXPECT_EQ(soup.groups,
            (std::vector<SimplexSoup::Group>{{2, 19, "periodic x"}, {2, 20, "periodic x copy"}}));
}

TEST_F(PeriodicLinks, RefuseRotations) {
  SimplexSoup soup = cube(3);
  soup.periodic = {{2, 5, 6, {}, {{0, 1}, {4, 20}, {7, 63}}}};
  EXPECT_NE(error_of([&] { periodic_pairs(soup); }).find("no translated copies"), std::string::npos);
}

class PeriodicPeer : public IoTest {
 protected:
  int run(const std::string& command) const {
    return std::system(
        ("cd '" + directory.string() + "' && timeout 100 " + command + " >log.txt 2>&1").c_str());
  }
};

TEST_F(PeriodicPeer, GmshReadsTheLinksAndGivesThemBack) {
  if (run("gmsh --version") != 0) GTEST_SKIP() << "gmsh is not installed";
  const SimplexSoup soup = periodic_cube(0.3);
  for (const Form& form : volume_forms) {
    if (!form.name.ends_with("41.msh")) continue;  // of 2.2, Gmsh 4.8 gives back none, not even its own
    SCOPED_TRACE(form.name);
    write_simplices(directory / form.name, soup, form.options);
    ASSERT_EQ(run("gmsh -0 -save_all -format msh41 " + form.name + " -o out.msh"), 0);
    const std::string log = content(directory / "log.txt");
    EXPECT_EQ(log.find("Error"), std::string::npos) << log;
    EXPECT_EQ(log.find("Could not find"), std::string::npos) << log;
    const SimplexSoup again = read_simplices(directory / "out.msh");
    EXPECT_EQ(periodic_pairs(again).pairs, periodic_pairs(soup).pairs);
    EXPECT_EQ(periodic_pairs(again).translations, periodic_pairs(soup).translations);
  }
}

TEST_F(PeriodicPeer, MeshioReadsTheFile) {
  if (run("/usr/bin/python3 -c 'import meshio'") != 0) GTEST_SKIP() << "meshio is not installed";
  const SimplexSoup soup = periodic_cube();
  for (const Form& form : volume_forms) {
    if (!form.name.ends_with(".msh")) continue;
    SCOPED_TRACE(form.name);
    write_simplices(directory / form.name, soup, form.options);
    EXPECT_EQ(run("/usr/bin/python3 -c \"import meshio; m = meshio.read('" + form.name +
                  "'); assert len(m.gmsh_periodic) == 3 and all(len(p[3]) == 16 for p in m.gmsh_periodic)\""),
              0)
        << content(directory / "log.txt");
  }
}

}  // namespace
}  // namespace multimesh::io::test
