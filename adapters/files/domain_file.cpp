// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/domain_file.hpp"

#include "adapters/io/naming.hpp"
#include "adapters/io/used_points.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/coordinate_range.hpp"
#include "multimesh/io/simplex_reader.hpp"

namespace multimesh::files {

namespace {

void check_size(const DomainFile& file) {
  CoordinateRange range;
  for (const auto& block : file.soup.simplices)
    for (const std::uint32_t v : block.corners) range.add(v, file.soup.points[v].data());
  if (const std::string problem = range.problem(); !problem.empty())
    throw InputError(file.path.string() + ": " + problem);
}

}  // namespace

DomainFile read_simplices(const std::filesystem::path& path) {
  DomainFile file{path, io::read_simplices(path), {}};
  file.warnings = std::move(file.soup.warnings);
  check_size(file);
  if (file.soup.notes.unused_points != 0) io::remove_unused_points(file.soup);
  return file;
}

DomainFile read_domain(const std::filesystem::path& path, const DomainReadOptions& options) {
  DomainFile file = read_simplices(path);
  prepare(file, options);
  return file;
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

TetDomain take_domain(DomainFile& file, const TetDomainOptions& options) {
  const TaggedTetrahedra lists = take_tetrahedra(file);
  TetDomain domain = io::naming(file.path, [&] { return TetDomain(lists, options); });
  for (std::string& w : warnings_of(domain.report())) file.warnings.push_back(std::move(w));
  return domain;
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

}  // namespace multimesh::files
