// SPDX-License-Identifier: BSD-3-Clause
#include "tools/domain_file.hpp"

#include <algorithm>
#include <cctype>

#include "adapters/io/simplex_reader.hpp"
#include "adapters/io/simplex_writer.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tools {

bool is_surface_format(const std::filesystem::path& path) {
  auto plain = path;
  if (plain.extension() == ".gz") plain = plain.stem();
  std::string extension = plain.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off";
}

DomainFile read_domain_file(const std::filesystem::path& path) {
  DomainFile file{path, io::read_simplices(path), {}};
  file.warnings = std::move(file.soup.warnings);
  return file;
}

TaggedTetrahedra take_tetrahedra(DomainFile& file) {
  io::SimplexSoup& soup = file.soup;
  if (soup.simplices[3].size() == 0)
    throw InputError(file.path.string() +
                     ": has no tetrahedron; `multimesh tetrahedralize` makes them of a closed surface");
  const auto n = static_cast<Index>(soup.points.size());
  TaggedTetrahedra t;
  t.points = std::move(soup.points);
  t.fixed = std::move(soup.simplices[0].corners);
  t.edges = {1, n, std::move(soup.simplices[1].corners)};
  t.edge_tags = std::move(soup.simplices[1].tags);
  t.triangles = {2, n, std::move(soup.simplices[2].corners)};
  t.patches = std::move(soup.simplices[2].tags);
  t.tets = {3, n, std::move(soup.simplices[3].corners)};
  t.regions = std::move(soup.simplices[3].tags);
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
  return sentences;
}

void write_domain(const std::filesystem::path& path, const TetDomain& domain,
                  const std::vector<io::SimplexSoup::Group>& groups, const DomainWriteOptions& options,
                  std::vector<std::string>& warnings) {
  TaggedTetrahedra t = domain.tagged();
  io::SimplexSoup soup;
  soup.points = std::move(t.points);
  soup.simplices[0].corners = std::move(t.fixed);
  soup.simplices[0].tags.assign(soup.simplices[0].corners.size(), 0);
  soup.simplices[1] = {std::move(t.edges.corners), std::move(t.edge_tags), {}};
  soup.simplices[2] = {std::move(t.triangles.corners), std::move(t.patches), {}};
  soup.simplices[3] = {std::move(t.tets.corners), std::move(t.regions), {}};
  soup.groups = groups;
  const auto told = io::write_simplices(
      path, soup,
      {.msh_version = options.msh_2 ? io::MshVersion::v2_2 : io::MshVersion::v4_1, .binary = !options.ascii});
  warnings.insert(warnings.end(), told.begin(), told.end());
}

}  // namespace multimesh::tools
