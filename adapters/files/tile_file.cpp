// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/tile_file.hpp"

#include <algorithm>
#include <sstream>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/naming.hpp"
#include "adapters/io/periodic_links.hpp"

namespace multimesh::files {

namespace {

void warn_of_lost(const io::SimplexSoup& soup, std::vector<std::string>& warnings) {
  if (!soup.point_tags.empty()) warnings.emplace_back("tags of points are left out");
  const auto is_flagged = [](const auto& block) {
    return std::ranges::any_of(block.flags, [](auto flag) { return flag != 0; });
  };
  if (std::ranges::any_of(soup.simplices, is_flagged))
    warnings.emplace_back("flags of MEDIT (corners, ridges, required elements) are left out");
}

void add_sides(const PeriodicDomain& domain, int dimension, io::SimplexSoup& soup) {
  std::vector<io::PeriodicFaces> faces;
  for (const PeriodicSide& side : domain.sides()) {
    const auto t = domain.lattice().shift(side.shift);
    faces.push_back({name_of(side.shift), {t[0], t[1], t[2]}, side.master.corners, side.slave.corners});
  }
  io::add_periodic_faces(soup, dimension, faces);
}

std::string axes_text(const std::array<bool, 3>& axes) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i]) text.append(text.empty() ? "" : ", ").append(1, "xyz"[i]);
  return text;
}

}  // namespace

TileFile read_tile(const std::filesystem::path& path) {
  return to_tile(read_simplices(path));
}

TileFile to_tile(DomainFile file) {
  const int dimension = file.soup.dimension();
  if (dimension < 2)
    throw InputError(file.path.string() +
                     ": has no tetrahedra and no triangles; a periodic tile is made of them");
  TileFile out{file.path, {{}, {dimension, 0, {}}}, {}, file.groups(), std::move(file.warnings)};
  warn_of_lost(file.soup, out.warnings);
  io::naming(file.path, [&] {
    io::PeriodicPairs links = io::periodic_pairs(file.soup);
    if (!links.pairs.empty()) out.options = options_of_pairs(std::move(links.pairs), links.translations);
  });
  out.options.interfaces = true;
  const auto n = static_cast<Index>(file.soup.points.size());
  const auto take = [&](int k, FacetList& list, std::vector<PeriodicTile::Region>& tags) {
    auto& block = file.soup.simplices[static_cast<std::size_t>(k)];
    list = {k, n, std::move(block.corners)};
    tags = std::move(block.tags);
  };
  take(dimension, out.tile.facets, out.tile.regions);
  for (int k = 0; k < dimension; ++k) {
    auto& listed = out.tile.listed[static_cast<std::size_t>(k)];
    take(k, listed.simplices, listed.tags);
  }
  out.tile.points = std::move(file.soup.points);
  return out;
}

void set_periods(TileFile& file, const std::array<bool, 3>& axes,
                 const std::optional<std::array<std::array<double, 3>, 3>>& periods) {
  PeriodicOptions& options = file.options;
  const bool declared = !options.pairs.empty();
  bool same = declared && !periods;
  for (std::size_t i = 0; i < 3 && same; ++i) {
    const auto [low, high] = std::ranges::minmax(file.tile.points, {}, [&](const auto& p) { return p[i]; });
    same = axes[i] == options.axes[i] || (axes[i] && low[i] == high[i]);
  }
  if (same) return;
  if (declared)
    file.warnings.push_back(
        "the periodic links of the file are not used: sides are matched by place, along " + axes_text(axes));
  options.axes = axes;
  options.periods = periods;
  options.pairs.clear();
}

std::vector<std::string> warnings_of(const PeriodicReport& r) {
  std::vector<std::string> sentences;
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0) sentences.push_back(std::to_string(n) + " " + what);
  };
  if (const std::string axes = axes_text(r.dropped_axes); !axes.empty())
    sentences.push_back("the tile has no extent along " + axes + ": not periodic there");
  add(r.reversed_facets, "facets were turned round to agree with the others or to be positive");
  add(r.inverted_facets, "facets have no or negative size");
  add(r.cut_vertices, "copies were made of points at which the tile is not manifold");
  add(r.cut_root_vertices, "copies were made of points at which the glued tile is not manifold; they stay");
  add(r.split_edges, "edges were split until the glued tile was a simplicial complex");
  if (r.largest_shift > 1e-12) {
    std::ostringstream text;
    text << "copies of points were moved to fit exactly, by up to " << r.largest_shift << " of the diagonal";
    sentences.push_back(text.str());
  }
  add(r.missing_listed, "listed points, edges or triangles are not in the tile; left out");
  return sentences;
}

std::vector<std::string> write_tile(const std::filesystem::path& path, const PeriodicDomain& domain,
                                    const DomainGroups& groups, const io::SimplexWriteOptions& options) {
  PeriodicTile tile = domain.tile_lists();
  const int dimension = tile.facets.dimension;
  io::SimplexSoup soup;
  soup.groups = groups.groups;
  soup.tag_sets = groups.tag_sets;
  soup.points = std::move(tile.points);
  for (int k = 0; k < dimension; ++k) {
    auto& listed = tile.listed[static_cast<std::size_t>(k)];
    soup.simplices[static_cast<std::size_t>(k)] = {
        std::move(listed.simplices.corners), std::move(listed.tags), {}};
  }
  tile.regions.resize(tile.facets.size());
  soup.simplices[static_cast<std::size_t>(dimension)] = {
      std::move(tile.facets.corners), std::move(tile.regions), {}};
  if (io::format_extension(path) == ".msh") {
    add_sides(domain, dimension - 1, soup);
    return io::write_simplices(path, soup, options);
  }
  std::vector<std::string> warnings = io::write_simplices(path, soup, options);
  warnings.push_back(path.string() +
                     ": periodic links are not written; .msh has them, and --pair-table writes the pairs");
  return warnings;
}

}  // namespace multimesh::files
