// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/glue_tile.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/domains/oriented_parts.hpp"
#include "multimesh/domains/periodic_domain/tile_links.hpp"

namespace multimesh {

namespace {

void reverse(FacetList& list, std::size_t f) {
  std::swap(list.corners[f * list.corners_per_facet()], list.corners[f * list.corners_per_facet() + 1]);
}

Vec3 area_vector(const LabelledTile& tile, const FacetList& list, std::size_t f) {
  const auto v = list.facet(f);
  const auto& p = tile.point;
  return cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]) / 2;
}

double volume(const LabelledTile& tile, const FacetList& list, std::size_t f) {
  const auto v = list.facet(f);
  return dot(area_vector(tile, list, f), tile.point[v[3]] - tile.point[v[0]]) / 3;
}

/// By the first component; its largest coordinate is positive.
Vec3 side_to_look_at(const LabelledTile& tile, const FacetList& list, const std::vector<Index>& component) {
  Vec3 sum{};
  for (std::size_t f = 0; f < list.size(); ++f)
    if (component[f] == component[0]) sum += area_vector(tile, list, f);
  const auto largest =
      std::max_element(sum.begin(), sum.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
  return *largest < 0 ? -sum : sum;
}

// Per component of the root.
void turn_positive(const LabelledTile& tile, FacetList& list, FacetList& root, std::vector<bool>& reversed) {
  const std::vector<Index> component = parts_of(root);
  const bool flat = list.dimension == 2;
  const Vec3 normal = flat ? side_to_look_at(tile, list, component) : Vec3{};
  std::vector<double> sizes(list.size());
  for (std::size_t f = 0; f < list.size(); ++f)
    sizes[f] = flat ? dot(area_vector(tile, list, f), normal) : volume(tile, list, f);
  const std::vector<bool> negative = in_negative_part(component, sizes);
  for (std::size_t f = 0; f < list.size(); ++f)
    if (negative[f]) {
      reverse(list, f), reverse(root, f);
      reversed[f] = !reversed[f];
    }
}

// If there is nothing to cut, the input's numbers stay.
void cut_tile(const LabelledTile& tile, GluedTile& glued, PeriodicReport& report) {
  Cut own = cut(glued.tile);
  const auto used = static_cast<std::size_t>(std::count_if(tile.vertex_class.begin(), tile.vertex_class.end(),
                                                           [](Index c) { return c != no_index; }));
  report.cut_vertices = own.source.size() - used;
  if (report.cut_vertices == 0) return;
  for (std::size_t f = 0; f < glued.tile.size(); ++f)
    if (own.reversed[f]) reverse(own.facets, f);
  glued.tile = std::move(own.facets);
  glued.source = std::move(own.source);
}

}  // namespace

GluedTile glue_tile(const LabelledTile& tile, PeriodicReport& report) {
  GluedTile glued;
  glued.tile = tile.facets;
  FacetList quotient{tile.facets.dimension, tile.classes, {}};
  for (const Index v : tile.facets.corners) quotient.corners.push_back(tile.vertex_class[v]);
  Cut root = cut(quotient);
  for (std::size_t f = 0; f < glued.tile.size(); ++f)
    if (root.reversed[f]) reverse(glued.tile, f);
  turn_positive(tile, glued.tile, root.facets, root.reversed);
  report.reversed_facets =
      static_cast<std::size_t>(std::count(root.reversed.begin(), root.reversed.end(), true));
  report.cut_root_vertices = root.facets.vertices - tile.classes;

  for (Index v = 0; v < tile.point.size(); ++v) glued.source.push_back(v);
  if (glued.tile.dimension == 2 || report.cut_root_vertices > 0 || !is_manifold_tile(tile))
    cut_tile(tile, glued, report);

  // Where more facets meet after gluing than two, the root is cut where the tile is not.
  std::vector<Index> image(glued.source.size(), no_index);
  for (std::size_t c = 0; c < glued.tile.corners.size(); ++c) {
    Index& of_vertex = image[glued.tile.corners[c]];
    if (of_vertex == no_index) of_vertex = root.facets.corners[c];
    if (of_vertex != root.facets.corners[c])
      throw InputError("the sides of the tile do not match facet by facet: around vertex " +
                       std::to_string(glued.source[glued.tile.corners[c]]) +
                       ", more than two facets meet after gluing");
  }
  glued.root = std::move(root.facets);
  glued.root_class = std::move(root.source);
  return glued;
}

}  // namespace multimesh
