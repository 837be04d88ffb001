// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "multimesh/domains/periodic_domain/fit_copies.hpp"
#include "multimesh/domains/periodic_domain/glue_tile.hpp"
#include "multimesh/domains/periodic_domain/match_sides.hpp"
#include "multimesh/domains/periodic_domain/open_sides.hpp"
#include "multimesh/domains/periodic_domain/quotient_edges.hpp"
#include "multimesh/domains/periodic_domain/refine_tile.hpp"

namespace multimesh {

namespace {

void check_lists(const PeriodicTile& in) {
  if (in.facets.dimension != 2 && in.facets.dimension != 3)
    throw InputError("a periodic tile has dimension 2 or 3, not " + std::to_string(in.facets.dimension));
  if (in.facets.corners.empty() || in.facets.corners.size() % in.facets.corners_per_facet() != 0)
    throw InputError("the tile has " + std::to_string(in.facets.corners.size()) + " corners, not " +
                     std::to_string(in.facets.corners_per_facet()) + " per facet");
  if (!in.regions.empty() && in.regions.size() != in.facets.size())
    throw InputError("the tile has " + std::to_string(in.facets.size()) + " facets and " +
                     std::to_string(in.regions.size()) + " regions of facets");
  FacetList facets = in.facets;
  facets.vertices = static_cast<Index>(in.points.size());
  require_corners(facets, [](std::size_t f) { return "facet " + std::to_string(f) + " of the tile"; });
  for (std::size_t k = 0; k < 3; ++k) {
    FacetList list = in.listed[k].simplices;
    list.vertices = facets.vertices;
    if (list.dimension != static_cast<int>(k) || in.listed[k].tags.size() != list.size())
      throw InputError("the lists of a tile have a tag per simplex, of dimensions 0, 1 and 2");
    if (list.size() > 0 && list.dimension >= facets.dimension)
      throw InputError("a tile lists simplices of lower dimensions than its facets");
    require_corners(list,
                    [](std::size_t s) { return "listed simplex " + std::to_string(s) + " of the tile"; });
  }
  for (const Index v : facets.corners)
    if (!std::ranges::all_of(in.points[v], [](double x) { return std::isfinite(x); }))
      throw InputError("the coordinates of vertex " + std::to_string(v) + " are not finite");
}

Lattice lattice_of(const PeriodicOptions& options, const Vec3& extents, double tolerance,
                   std::array<bool, 3>& dropped) {
  Eigen::Matrix3d periods = Eigen::Vector3d(extents.data()).asDiagonal();
  std::array<bool, 3> axes = options.axes;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    if (options.periods) periods.col(i) = Eigen::Vector3d((*options.periods)[axis].data());
    if (!axes[axis] || periods.col(i).norm() > 4 * tolerance) continue;
    if (options.periods) throw InputError(std::string("the period along ") + "xyz"[i] + " is 0");
    axes[axis] = false;
    dropped[axis] = true;
  }
  if (std::none_of(axes.begin(), axes.end(), [](bool on) { return on; })) {
    const auto flat = std::ranges::find(dropped, true);
    throw InputError(flat == dropped.end()
                         ? "the tile has no periodic axis"
                         : std::string("the tile has no extent along ") + "xyz"[flat - dropped.begin()] +
                               ": that axis is not periodic");
  }
  return Lattice(axes, periods);
}

std::vector<Index> used_vertices(const FacetList& facets) {
  std::vector<bool> is_used(facets.vertices, false);
  for (const Index v : facets.corners) is_used[v] = true;
  std::vector<Index> used;
  for (Index v = 0; v < facets.vertices; ++v)
    if (is_used[v]) used.push_back(v);
  return used;
}

void make_proper(LabelledTile& tile, bool refine, PeriodicReport& report) {
  if (const auto reason = too_short(tile)) {
    if (!refine)
      throw InputError("the glued tile is no simplicial complex: " + *reason +
                       ". Refine the tile (PeriodicOptions::refine), or make it of several cells");
    const std::size_t before = tile.facets.size();
    report.split_edges = refine_tile(tile);
    report.added_facets = tile.facets.size() - before;
  }
  if (const auto pair = double_facet(tile))
    throw InputError("facets " + std::to_string((*pair)[0]) + " and " + std::to_string((*pair)[1]) +
                     " of the tile lie at the same place");
}

}  // namespace

PreparedTile prepare_tile(const PeriodicTile& input, const PeriodicOptions& options, PeriodicReport& report) {
  check_lists(input);
  LabelledTile tile;
  tile.facets = input.facets;
  tile.facets.vertices = static_cast<Index>(input.points.size());
  for (const auto& p : input.points) tile.point.emplace_back(p);
  for (Index f = 0; f < tile.facets.size(); ++f) tile.input_facet.push_back(f);

  const std::vector<Index> used = used_vertices(tile.facets);
  Vec3 low = tile.point[used[0]], high = low;
  for (const Index v : used) low = min(low, tile.point[v]), high = max(high, tile.point[v]);
  const double diagonal = (high - low).norm();
  if (!(options.tolerance > 0 && options.tolerance < 0.1))
    throw InputError("the tolerance of a periodic tile must be between 0 and 0.1 of its diagonal");
  if (!(diagonal > 0)) throw InputError("all vertices of the tile lie at the same place");
  const double tolerance = options.tolerance * diagonal;

  Lattice lattice =
      lattice_of(options, box_without_noise(tile.point, used, diagonal), tolerance, report.dropped_axes);
  VertexClasses classes(tile.point.size());
  std::vector<LatticeVector> vectors;
  if (options.pairs.empty()) {
    vectors = vectors_within(lattice, tile.point, used, tolerance);
    match_sides(lattice, tile.point, used, vectors, tolerance, classes);
  } else {
    match_pairs(lattice, tile.point, options.pairs, tolerance, classes);
  }

  // Representatives that are no corner of a facet (pairs of a file may name such vertices) count as well.
  std::vector<Index> number(tile.point.size(), no_index);
  tile.vertex_class.assign(tile.point.size(), no_index);
  tile.offset.resize(tile.point.size());
  for (const Index v : used) {
    Index& n = number[classes.representative(v)];
    if (n == no_index) n = tile.classes++;
    tile.vertex_class[v] = n;
    tile.offset[v] = classes.offset(v);
  }
  report.largest_shift = fit_copies(tile, lattice, classes, diagonal);
  require_no_open_sides(tile, lattice, vectors, tolerance);
  make_proper(tile, options.refine, report);
  return {std::move(tile), std::move(lattice), diagonal};
}

}  // namespace multimesh
