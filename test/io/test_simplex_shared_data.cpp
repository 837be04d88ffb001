// SPDX-License-Identifier: BSD-3-Clause
// Every file of the shared collection is read with the numbers of its manifest, which other programs counted,
// or is refused with the reason.
#include <map>
#include <regex>
#include <sstream>

#include "adapters/io/group_tags.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

using Row = std::vector<std::string>;

/// The rows of one folder's table: file name and cells.
std::map<std::string, Row> manifest(const fs::path& root, const std::string& folder) {
  std::map<std::string, Row> rows;
  std::istringstream text(content(root / "MANIFEST.md"));
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("| `" + folder + "/")) continue;
    Row row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '|');)
      row.push_back(std::regex_replace(cell, std::regex("^ +| +$"), ""));
    const std::string path = row.at(1).substr(1, row[1].size() - 2);
    if (path.find('`') != std::string::npos) continue;  // a remark on several files: it has no numbers
    rows[path.substr(folder.size() + 1)] = row;
  }
  return rows;
}

/// The numbers of `a / b / c`.
std::vector<std::size_t> numbers(const std::string& cell) {
  std::vector<std::size_t> result;
  static const std::regex number("[0-9]+");
  for (auto at = std::sregex_iterator(cell.begin(), cell.end(), number); at != std::sregex_iterator(); ++at)
    result.push_back(std::stoul(at->str()));
  return result;
}

/// `tag:number` for every tag that the cell lists.
void expect_tags(const SimplexSoup::Block& block, const std::string& cell) {
  std::map<std::int32_t, std::size_t> counted;
  for (const std::int32_t tag : block.tags) ++counted[tag];
  static const std::regex pair("(-?[0-9]+):([0-9]+)");
  for (auto at = std::sregex_iterator(cell.begin(), cell.end(), pair); at != std::sregex_iterator(); ++at)
    EXPECT_EQ(counted[std::stoi((*at)[1])], std::stoul((*at)[2])) << "tag " << (*at)[1];
}

const std::map<std::string, std::string> refused = {
    {"hybrid_lshape_L1.msh", ":169: the element is a pyramid"},
    {"gmsh_periodic_structured_cube.msh", ":1127: the element is a hexahedron"},
    {"gmsh_periodic_structured_cube_v41.msh", ":1920: the element is a hexahedron"},
    {"mfem-periodic-tri.mesh", ":108: the mesh is curved or periodic"},
    {"periodic-hexagon.mesh", ":42: the mesh is curved or periodic"},
    {"periodic-square.mesh", ":36: the mesh is curved or periodic"}};

/// The soup, after the check that the file is read, or refused as it should.
bool read_or_refused(const fs::path& path, SimplexSoup& soup) {
  const std::string name = path.filename().string();
  const std::string error = error_of([&] { soup = read_simplices(path); });
  const auto expected = refused.find(name);
  if (expected == refused.end())
    EXPECT_EQ(error, "");
  else
    EXPECT_NE(error.find(name + expected->second), std::string::npos) << error;
  expect_valid(soup);
  return error.empty();
}

TEST(SimplexSharedData, TetrahedralMeshes) {
  const fs::path folder = shared("tet");
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  const auto rows = manifest(folder.parent_path(), "tet");
  EXPECT_EQ(rows.size(), 21U);
  for (const auto& [name, row] : rows) {
    SCOPED_TRACE(name);
    SimplexSoup soup;
    if (!read_or_refused(folder / name, soup)) continue;
    const auto sizes = numbers(row.at(4));  // V / tets / F; none for the .ele file of a pair
    if (sizes.size() != 3) continue;
    EXPECT_EQ(soup.points.size(), sizes[0]);
    EXPECT_EQ(soup.simplices[3].size(), sizes[1]);
    // The manifest does not count triangles of order four.
    if (name != "polyfem-data_coarse_P4.msh") {
      EXPECT_EQ(soup.simplices[2].size(), sizes[2]);
    }
    expect_tags(soup.simplices[3], row.at(5));
  }
}

/// How often the simplices of a dimension are listed in a file that lists them once for each group.
std::size_t listings(const SimplexSoup& soup, int k) {
  std::size_t count = 0;
  for (const std::int32_t tag : soup.simplices[static_cast<std::size_t>(k)].tags)
    count += groups_of(soup, k, tag).size();
  return count;
}

TEST(SimplexSharedData, PeriodicMeshes) {
  const fs::path folder = shared("periodic");
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  const auto rows = manifest(folder.parent_path(), "periodic");
  EXPECT_EQ(rows.size(), 24U);
  for (const auto& [name, row] : rows) {
    SCOPED_TRACE(name);
    SimplexSoup soup;
    if (!read_or_refused(folder / name, soup)) continue;
    const auto sizes = numbers(row.at(4));  // V / F / tets / lines
    ASSERT_EQ(sizes.size(), 4U);
    EXPECT_EQ(soup.points.size(), sizes[0]);
    EXPECT_EQ(soup.simplices[2].size(), sizes[1]);
    EXPECT_EQ(soup.simplices[3].size(), sizes[2]);
    // Lines that are in two groups are listed twice in one version, and once in the other.
    EXPECT_TRUE(listings(soup, 1) == sizes[3] || soup.simplices[1].size() == sizes[3]) << sizes[3];
  }
}

TEST(SimplexSharedData, CornersAndRidgesOfTheCube) {
  const fs::path folder = shared("tet");
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  const SimplexSoup soup = read_simplices(folder / "cube.mesh");
  EXPECT_EQ(soup.simplices[0].flags, std::vector<std::uint8_t>(8, feature_flag));
  EXPECT_EQ(soup.simplices[1].flags, std::vector<std::uint8_t>(60, feature_flag));
}

/// A pair is a translation by the affine map.
TEST(SimplexSharedData, PeriodicPairsAreWhereTheyShould) {
  const fs::path folder = shared("periodic");
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  std::size_t checked = 0;
  for (const fs::path& path : files_under(folder, ".msh")) {
    SimplexSoup soup;
    if (!error_of([&] { soup = read_simplices(path); }).empty()) continue;
    for (const auto& link : soup.periodic) {
      if (link.affine.size() != 16) continue;
      for (const auto& [slave, master] : link.points) {
        const auto &s = soup.points[slave], &m = soup.points[master];
        for (std::size_t r = 0; r < 3; ++r) {
          const double* row = &link.affine[4 * r];
          EXPECT_NEAR(row[0] * m[0] + row[1] * m[1] + row[2] * m[2] + row[3], s[r], 1e-9) << path;
        }
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1000U);
}

TEST(SimplexSharedData, EveryVolumeRoundTripsInEveryFormat) {
  const fs::path folder = shared("tet");
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  const fs::path out = fs::temp_directory_path() / ("multimesh-shared-" + std::to_string(::getpid()));
  fs::create_directories(out);
  for (const char* name : {"cube.mesh", "neper_statelt2d_ref.msh", "sphere3.msh.gz", "beam-tet.mesh"})
    for (const Form& form : volume_forms) {
      SCOPED_TRACE(std::string(name) + " " + form.name);
      SimplexSoup soup = read_simplices(folder / name);
      write_simplices(out / form.name, soup, form.options);
      const SimplexSoup again = read_simplices(out / form.name);
      if (form.name.ends_with(".msh")) make_tags_positive(soup);
      EXPECT_EQ(bits(soup.points), bits(again.points));
      for (std::size_t k = form.name == "a.mesh" ? 1 : 0; k < 4; ++k) {
        EXPECT_EQ(soup.simplices[k].corners, again.simplices[k].corners);
        EXPECT_EQ(soup.simplices[k].tags, again.simplices[k].tags);
      }
      if (form.name.ends_with(".msh")) {
        EXPECT_EQ(soup.groups, again.groups);
      }
    }
  fs::remove_all(out);
}

/// The manifest counts vertices after an exact merge, and faces as they are in the file.
TEST(SimplexSharedData, SurfacesInStlAndOff) {
  const fs::path root = fs::path(MULTIMESH_SHARED_DATA);
  if (shared("thingi10k").empty()) GTEST_SKIP() << "no shared data";
  std::size_t read = 0;
  for (const char* folder : {"thingi10k", "surface_closed", "surface_open", "surface_dirty"})
    for (const auto& [name, row] : manifest(root, folder)) {
      if (name.find(".stl") == std::string::npos && name.find(".off") == std::string::npos) continue;
      SCOPED_TRACE(name);
      PolygonSoup soup;
      const std::string error = error_of([&] { soup = read_mesh(root / folder / name, {1, 1}); });
      EXPECT_EQ(error, "");
      const auto sizes = numbers(row.at(4));
      ASSERT_GE(sizes.size(), 2U);
      EXPECT_EQ(soup.positions.size(), sizes[0]);
      EXPECT_EQ(soup.face_count() + soup.notes.collapsed_faces, sizes[1]);
      ++read;
    }
  EXPECT_GT(read, 90U);
}

}  // namespace
}  // namespace multimesh::io::test
