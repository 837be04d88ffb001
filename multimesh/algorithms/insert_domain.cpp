// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insert_domain.hpp"

#include <algorithm>
#include <map>

#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/tet_sides.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

using Tag = TaggedTetrahedra::Tag;

std::vector<std::array<Index, 3>> sorted_faces(const FacetList& faces) {
  std::vector<std::array<Index, 3>> keys;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto v = faces.facet(f);
    keys.push_back({v[0], v[1], v[2]});
    std::ranges::sort(keys.back());
  }
  std::ranges::sort(keys);
  return keys;
}

/// Tetrahedra that are joined by faces that are not in the soup. That at the border of the box is region 1.
Tag number_regions(const Arrangement& a, std::vector<Tag>& regions) {
  const auto in_soup = sorted_faces(a.faces);
  UnionFind parts(a.tets.size());
  Index outside = 0;
  const auto vertex_of = [&](Index corner) { return a.tets.corners[corner]; };
  for_each_face(a.tets, [&](std::span<const Index> sides) {
    if (sides.size() == 1) {
      outside = sides[0] / 4;
      return;
    }
    std::array<Index, 3> face = side_corners(sides[0], vertex_of);
    for (Index& v : face) v = vertex_of(v);
    if (!std::ranges::binary_search(in_soup, face)) parts.join(sides[0] / 4, sides[1] / 4);
  });
  std::map<Index, Tag> number{{parts.find(outside), 1}};
  for (Index t = 0; t < a.tets.size(); ++t)
    regions.push_back(number.try_emplace(parts.find(t), static_cast<Tag>(number.size() + 1)).first->second);
  return static_cast<Tag>(number.size());
}

void number_patches(const Arrangement& a, const TriangleSoup& soup, ArrangementLists& out) {
  const auto label = [&](Index polygon) {
    return soup.labels.empty() ? Tag{1} : soup.labels[a.triangles[polygon].front()];
  };
  std::map<std::vector<Tag>, Tag> overlaps;
  Tag next = soup.labels.empty() ? 2 : *std::ranges::max_element(soup.labels) + 1;
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    std::vector<Tag> labels;
    for (std::size_t i = a.begin[f]; i < a.begin[f + 1]; ++i) labels.push_back(label(a.covers[i].polygon));
    std::ranges::sort(labels);
    const auto repeated = std::ranges::unique(labels);
    labels.erase(repeated.begin(), repeated.end());
    Tag tag = labels.front();
    if (labels.size() > 1) {
      const auto [known, is_new] = overlaps.try_emplace(labels, next);
      tag = known->second;
      if (is_new) out.overlaps.push_back({next++, labels});
    }
    out.tets.patches.push_back(tag);
  }
}

}  // namespace

ArrangementLists lists_of(const Arrangement& a, const TriangleSoup& soup) {
  ArrangementLists out;
  std::vector<Index> number(a.points.size(), no_index);
  const auto add = [&](const FacetList& from, FacetList& to) {
    for (const Index v : from.corners) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(out.tets.points.size());
        out.tets.points.push_back(a.points[v].nearest());
      }
      to.corners.push_back(number[v]);
    }
  };
  add(a.tets, out.tets.tets);
  add(a.faces, out.tets.triangles);
  out.tets.tets.vertices = out.tets.triangles.vertices = static_cast<Index>(out.tets.points.size());
  out.regions = number_regions(a, out.tets.regions);
  number_patches(a, soup, out);
  for (std::size_t t = 0; t < out.tets.tets.size(); ++t) {
    const auto v = out.tets.tets.facet(t);
    const auto at = [&](std::size_t i) { return out.tets.points[v[i]].data(); };
    out.inverted += orient3d(at(0), at(1), at(2), at(3)) <= 0;
  }
  return out;
}

}  // namespace multimesh
