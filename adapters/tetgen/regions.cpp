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

/// Sorts three corners; true if that is an even permutation.
bool sort_corners(Corners& c) {
  bool even = true;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (c[i] > c[j]) std::swap(c[i], c[j]), even = !even;
  };
  order(0, 1), order(1, 2), order(0, 1);
  return even;
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

/// A face on the surface: sorted corners, and whether these have the orientation of the triangle.
struct Patch {
  Corners key{};
  Index triangle = 0;
  bool even = false;
};

/// Gives each face of the result that is on the surface its triangle's orientation.
std::vector<Patch> sorted_patches(const RawTetrahedra& raw, std::span<const Index> corners,
                                  bool split_surface) {
  std::vector<Patch> patches;
  patches.reserve(raw.faces.size());
  for (const RawTetrahedra::Face& face : raw.faces) {
    if (face.triangle >= corners.size() / 3) fail("a face has no triangle");
    Patch patch{face.corners, face.triangle, false};
    sort_corners(patch.key);
    Corners own{corners[3 * face.triangle], corners[3 * face.triangle + 1], corners[3 * face.triangle + 2]};
    if (split_surface) {
      patch.even = dot(area_vector(raw.points, patch.key), area_vector(raw.points, own)) > 0;
    } else {
      patch.even = sort_corners(own);
      if (own != patch.key) fail("triangle " + std::to_string(face.triangle) + " is not one of its faces");
    }
    patches.push_back(patch);
  }
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.key < b.key; });
  return patches;
}

/// What a patch separates: nodes are tetrahedra, the last one is the outside.
struct Link {
  Index inside = 0, outside = 0;
};

/// Goes over all faces. Joins tetrahedra that no patch separates; gives what the patches separate.
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
      // The tetrahedron behind the triangle is the one whose outward orientation is the triangle's.
      const bool is_inside = sides[i].even() == patch->even;
      links.push_back(is_inside ? Link{sides[i].tet(), other} : Link{other, sides[i].tet()});
      ++patch;
    } else if (other == outside) {
      fail("a face at its border is not on the surface");
    } else {
      joined.join(sides[i].tet(), other);
    }
    i = end;
  }
  if (patch != patches.end()) fail("a face on the surface has no tetrahedron, or two triangles");
  return links;
}

/// Follows the links from the outside, where the winding number is 0.
std::vector<int> winding_numbers(const std::vector<Link>& links, std::size_t regions) {
  std::vector<std::vector<std::pair<Index, int>>> next(regions + 1);
  for (const Link& link : links) {
    next[link.inside].push_back({link.outside, -1});
    next[link.outside].push_back({link.inside, 1});
  }
  std::vector<int> winding(regions + 1, 0);
  std::vector<bool> reached(regions + 1, false);
  std::vector<Index> queue{static_cast<Index>(regions)};
  reached[regions] = true;
  for (std::size_t q = 0; q < queue.size(); ++q)
    for (const auto& [to, step] : next[queue[q]]) {
      if (!reached[to]) winding[to] = winding[queue[q]] + step, queue.push_back(to), reached[to] = true;
      if (winding[to] != winding[queue[q]] + step) fail("a region has two winding numbers");
    }
  if (queue.size() != regions + 1) fail("a region is separated from the outside by no triangle");
  winding.pop_back();
  return winding;
}

void check_volumes(const Regions& regions, long double enclosed) {
  long double wound = 0, all = 0;
  for (std::size_t r = 0; r < regions.winding.size(); ++r) {
    wound += regions.winding[r] * regions.volume[r];
    all += std::abs(regions.winding[r]) * regions.volume[r];
  }
  if (!(std::abs(wound - enclosed) <= 1e-9L * all))
    fail("its volume is " + std::to_string(static_cast<double>(wound)) + " instead of " +
         std::to_string(static_cast<double>(enclosed)));
}

void check_corners(const RawTetrahedra& raw) {
  const auto is_point = [&](Index v) { return v < raw.points.size(); };
  for (const auto& tet : raw.tets)
    if (!std::all_of(tet.begin(), tet.end(), is_point)) fail("a corner is not one of its points");
  for (const auto& face : raw.faces)
    if (!std::all_of(face.corners.begin(), face.corners.end(), is_point))
      fail("a corner is not one of its points");
  constexpr std::size_t most = no_index / 2;
  if (raw.tets.empty() || raw.tets.size() >= most) fail("it has no tetrahedra, or too many");
}

}  // namespace

Regions find_regions(const RawTetrahedra& raw, std::span<const Index> corners, bool split_surface) {
  check_corners(raw);
  const std::vector<Patch> patches = sorted_patches(raw, corners, split_surface);
  const auto outside = static_cast<Index>(raw.tets.size());
  UnionFind joined(raw.tets.size());
  std::vector<Link> links = link_sides(sorted_sides(raw), patches, outside, joined);

  Regions regions;
  regions.of_tet.resize(raw.tets.size());
  std::vector<Index> number(raw.tets.size() + 1, no_index);
  for (Index t = 0; t < raw.tets.size(); ++t) {
    Index& region = number[joined.find(t)];
    if (region == no_index) region = static_cast<Index>(regions.volume.size()), regions.volume.push_back(0);
    regions.of_tet[t] = region;
    const long double volume = volume_of(raw.points, raw.tets[t]);
    if (!(volume > -least_volume(raw.points, raw.tets[t])))
      fail("tetrahedron " + std::to_string(t) + " is not positive");
    regions.volume[region] += volume;
  }
  const auto regions_size = regions.volume.size();
  const auto region_of = [&](Index tet) {
    return tet == outside ? static_cast<Index>(regions_size) : regions.of_tet[tet];
  };
  for (Link& link : links) link = {region_of(link.inside), region_of(link.outside)};
  regions.winding = winding_numbers(links, regions_size);
  check_volumes(regions, enclosed_volume(raw.points, corners));

  for (const Patch& p : patches) {
    const Corners& c = p.key;
    regions.faces.push_back({p.even ? c : Corners{c[1], c[0], c[2]}, p.triangle});
  }
  std::sort(regions.faces.begin(), regions.faces.end(), [](const SurfaceFace& a, const SurfaceFace& b) {
    return std::tie(a.triangle, a.corners) < std::tie(b.triangle, b.corners);
  });
  if (const Index missing = first_uncovered(raw.points, corners, regions.faces); missing != no_index)
    fail("triangle " + std::to_string(missing) + " is not covered by its faces");
  return regions;
}

}  // namespace multimesh::tetgen
