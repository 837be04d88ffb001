// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/tile_file.hpp"

#include "adapters/io/naming.hpp"
#include "adapters/io/periodic_links.hpp"

namespace multimesh::files {

namespace {

/// Of those of all dimensions.
DomainGroups groups_of_facets(const io::SimplexSoup& soup, int dimension) {
  DomainGroups kept;
  for (const auto& g : soup.groups)
    if (g.dimension == dimension) kept.groups.push_back(g);
  for (const auto& set : soup.tag_sets)
    if (set.dimension == dimension) kept.tag_sets.push_back(set);
  return kept;
}

void warn_of_lower(const io::SimplexSoup& soup, int dimension, std::vector<std::string>& warnings) {
  constexpr const char* names[] = {"points", "edges", "triangles"};
  std::string list;
  for (int k = 0; k < dimension; ++k)
    if (const std::size_t n = soup.simplices[static_cast<std::size_t>(k)].size(); n > 0)
      list.append(list.empty() ? "" : ", ").append(std::to_string(n)).append(" ").append(names[k]);
  if (!list.empty()) warnings.push_back("listed " + list + " are left out: a tile has its facets only");
}

void add_sides(const PeriodicDomain& domain, int dimension, io::SimplexSoup& soup) {
  std::vector<io::PeriodicFaces> faces;
  for (const PeriodicSide& side : domain.sides()) {
    const auto t = domain.lattice().shift(side.shift);
    faces.push_back({name_of(side.shift), {t[0], t[1], t[2]}, side.master.corners, side.slave.corners});
  }
  io::add_periodic_faces(soup, dimension, faces);
}

}  // namespace

TileFile read_tile(const std::filesystem::path& path) {
  DomainFile file = read_simplices(path);
  const int dimension = file.soup.dimension();
  if (dimension < 2)
    throw InputError(path.string() + ": has no tetrahedra and no triangles; a periodic tile is made of them");
  TileFile out{path, {{}, {dimension, 0, {}}}, {}, groups_of_facets(file.soup, dimension), {}};
  out.warnings = std::move(file.warnings);
  warn_of_lower(file.soup, dimension, out.warnings);
  io::naming(path, [&] {
    io::PeriodicPairs links = io::periodic_pairs(file.soup);
    if (!links.pairs.empty()) out.options = options_of_pairs(std::move(links.pairs), links.translations);
  });
  auto& facets = file.soup.simplices[static_cast<std::size_t>(dimension)];
  out.tile.facets.vertices = static_cast<Index>(file.soup.points.size());
  out.tile.facets.corners = std::move(facets.corners);
  out.tile.regions = std::move(facets.tags);
  out.tile.points = std::move(file.soup.points);
  return out;
}

std::vector<std::string> write_tile(const std::filesystem::path& path, const PeriodicDomain& domain,
                                    const DomainGroups& groups, const io::SimplexWriteOptions& options) {
  PeriodicTile tile = domain.tile_lists();
  const int dimension = tile.facets.dimension;
  io::SimplexSoup soup;
  soup.groups = groups.groups;
  soup.tag_sets = groups.tag_sets;
  soup.points = std::move(tile.points);
  tile.regions.resize(tile.facets.size());
  soup.simplices[static_cast<std::size_t>(dimension)] = {
      std::move(tile.facets.corners), std::move(tile.regions), {}};
  add_sides(domain, dimension - 1, soup);
  return io::write_simplices(path, soup, options);
}

}  // namespace multimesh::files
