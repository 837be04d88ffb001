// SPDX-License-Identifier: BSD-3-Clause
#include "tools/domain_file.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/polygons_to_simplices.hpp"
#include "adapters/io/simplex_reader.hpp"
#include "adapters/io/simplex_writer.hpp"
#include "adapters/io/soup_check.hpp"
#include "adapters/io/used_points.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/coordinate_range.hpp"

namespace multimesh::tools {

bool is_surface_format(const std::filesystem::path& path) {
  const std::string extension = io::format_extension(path);
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off";
}

namespace {

void check_size(const DomainFile& file) {
  CoordinateRange range;
  for (const auto& block : file.soup.simplices)
    for (const std::uint32_t v : block.corners) range.add(v, file.soup.points[v].data());
  if (const std::string problem = range.problem(); !problem.empty())
    throw InputError(file.path.string() + ": " + problem);
}

}  // namespace

DomainFile read_domain_file(const std::filesystem::path& path) {
  DomainFile file{path, io::read_simplices(path), {}};
  file.warnings = std::move(file.soup.warnings);
  check_size(file);
  if (file.soup.notes.unused_points != 0) io::remove_unused_points(file.soup);
  return file;
}

std::vector<std::int32_t> tags_of_groups(const DomainFile& file, int dimension,
                                         const std::vector<std::int32_t>& groups, const std::string& option) {
  const auto& tags = file.soup.simplices[static_cast<std::size_t>(dimension)].tags;
  const std::set<std::int32_t> present(tags.begin(), tags.end());
  std::set<std::int32_t> known;
  for (const std::int32_t tag : present)
    for (const std::int32_t group : io::groups_of(file.soup, dimension, tag)) known.insert(group);
  std::vector<std::int32_t> found;
  for (const std::int32_t group : groups) {
    if (!known.contains(group)) {
      std::string list;
      for (const std::int32_t k : known) list.append(list.empty() ? "" : ", ").append(std::to_string(k));
      throw InputError(option + " " + std::to_string(group) + ": " + file.path.string() +
                       " has no such tag; it has " + list);
    }
    for (const std::int32_t tag : io::tags_with(file.soup, dimension, group))
      if (present.contains(tag)) found.push_back(tag);
  }
  return found;
}

std::vector<std::int32_t> tags_of_patches(const DomainFile& file, const std::vector<std::string>& patches,
                                          const std::string& option) {
  const auto group_of = [&](const std::string& patch) {
    for (const io::SimplexSoup::Group& g : file.soup.groups)
      if (g.dimension == 2 && g.name == patch) return static_cast<std::int32_t>(g.tag);
    std::int32_t tag{};
    const auto [end, error] = std::from_chars(patch.data(), patch.data() + patch.size(), tag);
    if (error == std::errc() && end == patch.data() + patch.size()) return tag;
    throw InputError(file.path.string() + ": " + option + " " + patch + ": no patch has this name");
  };
  std::vector<std::int32_t> groups;
  for (const std::string& patch : patches) groups.push_back(group_of(patch));
  return tags_of_groups(file, 2, groups, option);
}

TaggedTetrahedra take_tetrahedra(DomainFile& file) {
  io::SimplexSoup& soup = file.soup;
  if (soup.simplices[3].size() == 0)
    throw InputError(file.path.string() +
                     ": has no tetrahedron; `multimesh tetrahedralize` makes them of a closed surface");
  const auto n = static_cast<Index>(soup.points.size());
  auto& [points, edges, triangles, tets] = soup.simplices;
  TaggedTetrahedra t;
  t.points = std::move(soup.points);
  t.point_tags = std::move(soup.point_tags);
  t.fixed = std::move(points.corners);
  t.fixed_tags = std::move(points.tags);
  t.fixed_flags = std::move(points.flags);
  t.edges = {1, n, std::move(edges.corners)};
  t.edge_tags = std::move(edges.tags);
  t.edge_flags = std::move(edges.flags);
  t.triangles = {2, n, std::move(triangles.corners)};
  t.patches = std::move(triangles.tags);
  t.triangle_flags = std::move(triangles.flags);
  t.tets = {3, n, std::move(tets.corners)};
  t.regions = std::move(tets.tags);
  t.tet_flags = std::move(tets.flags);
  return t;
}

TexturedTriangles triangles_of(const DomainFile& file) {
  TexturedTriangles t;
  for (const auto& p : file.soup.points) t.positions.emplace_back(p[0], p[1], p[2]);
  const auto& block = file.soup.simplices[2];
  for (std::size_t f = 0; f < block.size(); ++f) {
    auto& triangle = t.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i].position = static_cast<std::int32_t>(block.corners[3 * f + i]);
    t.labels.push_back(static_cast<Index>(block.tags[f]));
  }
  return t;
}

io::PolygonSoup polygons_of(const DomainFile& file) {
  if (file.soup.points.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError(file.path.string() + ": more than 2147483647 points are too many for a surface");
  if (file.soup.simplices[2].size() + file.soup.simplices[1].size() == 0)
    throw InputError(file.path.string() + ": has no tetrahedra, triangles or edges");
  io::PolygonSoup soup = io::to_grouped_polygons(file.soup);
  soup.warnings = file.warnings;
  io::clean_faces(soup, file.path.string(), false);
  return soup;
}

std::vector<std::string> warnings_of(const TetDomainReport& r) {
  std::vector<std::string> sentences;
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0) sentences.push_back(std::to_string(n) + " " + what);
  };
  add(r.copied_vertices, "copies were made of points at which the mesh is not manifold");
  add(r.reversed_tets, "tetrahedra were turned round to agree with the others or to have positive volume");
  add(r.inverted_tets, "tetrahedra have no or negative volume");
  add(r.missing_triangles, "listed triangles are no face of a tetrahedron; left out");
  add(r.missing_edges, "listed edges are no edge of a tetrahedron; left out");
  add(r.missing_points, "listed points are no vertex of a tetrahedron; left out");
  add(r.unused_points, "points of the file are no vertex of a tetrahedron; left out");
  return sentences;
}

namespace {

/// The simplices that are to be written. \return which of them the input does not list
std::vector<std::size_t> add_block(io::SimplexSoup::Block& block, std::size_t k,
                                   const std::vector<Index>& corners, const std::vector<std::int32_t>& tags,
                                   const std::vector<std::uint8_t>& flags, bool with_unlisted) {
  std::vector<std::size_t> unlisted;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const bool is_listed = (flags[i] & unlisted_simplex) == 0;
    if (!is_listed && !with_unlisted) continue;
    if (!is_listed) unlisted.push_back(block.size());
    for (std::size_t c = 0; c <= k; ++c) block.corners.push_back(corners[(k + 1) * i + c]);
    block.tags.push_back(tags[i]);
    block.flags.push_back(flags[i] & (feature_simplex | required_simplex));
  }
  return unlisted;
}

io::SimplexSoup to_soup(TaggedTetrahedra t, const DomainGroups& groups, const DomainWriteOptions& options) {
  io::SimplexSoup soup;
  soup.groups = groups.groups;
  soup.tag_sets = groups.tag_sets;
  soup.points = std::move(t.points);
  if (std::ranges::any_of(t.point_tags, [](auto tag) { return tag != 0; }))
    soup.point_tags = std::move(t.point_tags);
  soup.simplices[3] = {std::move(t.tets.corners), std::move(t.regions), std::move(t.tet_flags)};
  auto& [points, edges, triangles, tets] = soup.simplices;
  const std::array<std::vector<std::size_t>, 3> unlisted = {
      add_block(points, 0, t.fixed, t.fixed_tags, t.fixed_flags, options.unlisted[0]),
      add_block(edges, 1, t.edges.corners, t.edge_tags, t.edge_flags, options.unlisted[1]),
      add_block(triangles, 2, t.triangles.corners, t.patches, t.triangle_flags, options.unlisted[2])};
  constexpr std::array<const char*, 3> names = {"fixed_points", "curves", "interfaces"};
  io::UnusedTags unused(soup);
  for (std::size_t k = 0; k < 3; ++k) {
    if (unlisted[k].empty()) continue;
    const std::int32_t tag = io::named_group(soup, static_cast<int>(k), names[k], unused);
    for (const std::size_t i : unlisted[k]) soup.simplices[k].tags[i] = tag;
  }
  return soup;
}

}  // namespace

void write_domain(const std::filesystem::path& path, const TetDomain& domain, const DomainGroups& groups,
                  const DomainWriteOptions& options, std::vector<std::string>& warnings) {
  const auto told = io::write_simplices(
      path, to_soup(domain.tagged(), groups, options),
      {.msh_version = options.msh_2 ? io::MshVersion::v2_2 : io::MshVersion::v4_1, .binary = !options.ascii});
  warnings.insert(warnings.end(), told.begin(), told.end());
}

}  // namespace multimesh::tools
