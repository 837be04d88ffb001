// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/regions.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "adapters/tetgen/surface_measure.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh::tetgen {

namespace {

using Corners = std::array<Index, 3>;

[[noreturn]] void fail(const std::string& what) {
  throw WorkerError(WorkerError::Reason::bad_result,
                    "TetGen's result is not a filling of the surface: " + what);
}

/// How the input calls a facet.
std::string triangle_name(const Facets& facets, Index facet) {
  return std::to_string(facets.sources_of(facet)[0].triangle);
}

/// One side of a face: the tetrahedron there, and whether its outward orientation is the sorted one.
struct Side {
  Corners key{};
  Index code = 0;
  Index tet() const { return code >> 1; }
  bool even() const { return code & 1; }
};

std::vector<Side> sorted_sides(const RawTetrahedra& raw) {
  std::vector<Side> sides;
  sides.reserve(raw.tets.size() * 4);
  for (Index t = 0; t < raw.tets.size(); ++t)
    for (const auto& face : outward_faces) {
      Side side;
      for (std::size_t k = 0; k < 3; ++k) side.key[k] = raw.tets[t][face[k]];
      const bool even = sort_corners(side.key);
      side.code = t << 1 | Index{even};
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
  return sides;
}

/// A face on a facet: sorted corners, and whether these have the orientation of the facet.
struct Patch {
  Corners key{};
  Index facet = 0;
  bool even = false;
};

/// Gives each face of the result that is on a facet that facet's orientation.
std::vector<Patch> sorted_patches(const RawTetrahedra& raw, const Facets& facets, bool split_surface) {
  std::vector<Patch> patches;
  patches.reserve(raw.faces.size());
  for (const RawTetrahedra::Face& face : raw.faces) {
    if (face.triangle == no_index) continue;  // of the convex hull only
    if (face.triangle >= facets.size()) fail("a face has no triangle");
    Patch patch{face.corners, face.triangle, false};
    sort_corners(patch.key);
    Corners own = facets.facet(face.triangle);
    if (split_surface) {
      patch.even = dot(area_vector(raw.points, patch.key), area_vector(raw.points, own)) > 0;
    } else {
      patch.even = sort_corners(own);
      if (own != patch.key)
        fail("triangle " + triangle_name(facets, face.triangle) + " is not one of its faces");
    }
    patches.push_back(patch);
  }
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.key < b.key; });
  return patches;
}

/// What a patch separates: nodes are tetrahedra, the last one is the outside.
struct Link {
  Index behind = 0, before = 0, facet = 0;
};

/// Goes over all faces. Joins what no patch separates; gives what the patches separate.
std::vector<Link> link_sides(const std::vector<Side>& sides, const std::vector<Patch>& patches, Index outside,
                             UnionFind& joined) {
  std::vector<Link> links;
  links.reserve(patches.size());
  auto patch = patches.begin();
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key == sides[i].key) ++end;
    if (end - i > 2 || (end - i == 2 && sides[i].even() == sides[i + 1].even()))
      fail("tetrahedra overlap at a face");
    const Index other = end - i == 2 ? sides[i + 1].tet() : outside;
    if (patch != patches.end() && patch->key == sides[i].key) {
      // The tetrahedron behind the facet is the one whose outward orientation is the facet's.
      const bool is_behind = sides[i].even() == patch->even;
      links.push_back({is_behind ? sides[i].tet() : other, is_behind ? other : sides[i].tet(), patch->facet});
      ++patch;
    } else {
      joined.join(sides[i].tet(), other);
    }
    i = end;
  }
  if (patch != patches.end()) fail("a face on the surface has no tetrahedron, or two triangles");
  return links;
}

void check_raw(const RawTetrahedra& raw) {
  const auto is_point = [&](Index v) { return v < raw.points.size(); };
  for (const auto& tet : raw.tets)
    if (!std::all_of(tet.begin(), tet.end(), is_point)) fail("a corner is not one of its points");
  for (const auto& face : raw.faces)
    if (!std::all_of(face.corners.begin(), face.corners.end(), is_point))
      fail("a corner is not one of its points");
  constexpr std::size_t most = no_index / 2;
  if (raw.tets.empty() || raw.tets.size() >= most) fail("it has no tetrahedra, or too many");
  for (std::size_t t = 0; t < raw.tets.size(); ++t)
    if (!(volume_of(raw.points, raw.tets[t]) > -least_volume(raw.points, raw.tets[t])))
      fail("tetrahedron " + std::to_string(t) + " is not positive");
}

/// Numbers the sets of tetrahedra in the order in which facets meet them; the outside gets no number.
class Numbering {
 public:
  Numbering(UnionFind& joined, Index outside) : joined_(joined), number_(std::size_t{outside} + 1, no_index) {
    outside_ = joined_.find(outside);
  }
  Index number(Index node) {
    const Index set = joined_.find(node);
    if (set == outside_) return no_index;
    if (number_[set] == no_index) number_[set] = count_++;
    return number_[set];
  }
  Index count() const { return count_; }

 private:
  UnionFind& joined_;
  std::vector<Index> number_;
  Index outside_ = 0, count_ = 0;
};

std::vector<Sides> find_sides(std::vector<Link>& links, const Facets& facets, Numbering& numbering) {
  std::stable_sort(links.begin(), links.end(),
                   [](const Link& a, const Link& b) { return a.facet < b.facet; });
  std::vector<Sides> sides(facets.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Sides own{numbering.number(links[i].behind), numbering.number(links[i].before)};
    const bool is_first = i == 0 || links[i - 1].facet != links[i].facet;
    if (!is_first && sides[links[i].facet] != own)
      fail("triangle " + triangle_name(facets, links[i].facet) + " goes through a region's border");
    sides[links[i].facet] = own;
  }
  return sides;
}

std::vector<FacetFace> oriented_faces(const std::vector<Patch>& patches) {
  std::vector<FacetFace> faces;
  faces.reserve(patches.size());
  for (const Patch& p : patches)
    faces.push_back({p.even ? p.key : Corners{p.key[1], p.key[0], p.key[2]}, p.facet});
  std::sort(faces.begin(), faces.end(), [](const FacetFace& a, const FacetFace& b) {
    return std::tie(a.facet, a.corners) < std::tie(b.facet, b.corners);
  });
  return faces;
}

void check_covered(const RawTetrahedra& raw, const Facets& facets, const Regions& regions,
                   const std::vector<bool>& may_be_missing) {
  const long double extent = diagonal(raw.points);
  auto face = regions.faces.begin();
  for (Index f = 0; f < facets.size(); ++f) {
    std::vector<Corners> parts;
    for (; face != regions.faces.end() && face->facet == f; ++face) parts.push_back(face->corners);
    if (parts.empty() && !may_be_missing.empty() && may_be_missing[f]) continue;
    if (!is_covered(raw.points, facets.facet(f), parts, extent))
      fail("triangle " + triangle_name(facets, f) + " is not covered by its faces");
  }
}

void check_volumes(const RawTetrahedra& raw, const Facets& facets, const Regions& regions) {
  std::vector<long double> enclosed(regions.volume.size(), 0);
  long double all = 0;
  for (Index f = 0; f < facets.size(); ++f) {
    const auto [behind, before] = regions.sides[f];
    if (behind == before) continue;
    // Seen from a point of the surface; from far away, the terms would be large and cancel.
    const long double cone = cone_volume(raw.points, facets.facet(f), raw.points[facets.corners[0]]);
    if (behind != no_index) enclosed[behind] += cone;
    if (before != no_index) enclosed[before] -= cone;
  }
  for (const long double v : regions.volume) all += v;
  for (std::size_t r = 0; r < enclosed.size(); ++r)
    if (!(std::abs(regions.volume[r] - enclosed[r]) <= 1e-9L * all))
      fail("the volume of a region is " + std::to_string(static_cast<double>(regions.volume[r])) +
           " instead of " + std::to_string(static_cast<double>(enclosed[r])));
}

}  // namespace

Regions find_regions(const RawTetrahedra& raw, const Facets& facets, const RegionOptions& options) {
  check_raw(raw);
  const std::vector<Patch> patches = sorted_patches(raw, facets, options.split_surface);
  const auto outside = static_cast<Index>(raw.tets.size());
  UnionFind joined(raw.tets.size() + 1);
  std::vector<Link> links = link_sides(sorted_sides(raw), patches, outside, joined);

  Regions regions;
  Numbering numbering(joined, outside);
  regions.sides = find_sides(links, facets, numbering);
  regions.faces = oriented_faces(patches);
  regions.volume.assign(numbering.count(), 0);
  for (Index t = 0; t < raw.tets.size(); ++t) {
    regions.of_tet.push_back(numbering.number(t));
    if (numbering.count() > regions.volume.size()) fail("a region is bounded by no triangle");
    if (regions.of_tet[t] != no_index)
      regions.volume[regions.of_tet[t]] += volume_of(raw.points, raw.tets[t]);
  }
  check_covered(raw, facets, regions, options.may_be_missing);
  check_volumes(raw, facets, regions);
  return regions;
}

}  // namespace multimesh::tetgen
