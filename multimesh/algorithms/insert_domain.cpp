// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insert_domain.hpp"

#include <algorithm>
#include <map>

#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

using Tag = TaggedTetrahedra::Tag;

struct Side {
  std::array<Index, 3> face;
  Index tet;
};

/// The faces of all tetrahedra, corners and faces ascending.
std::vector<Side> sides_of(const FacetList& tets) {
  std::vector<Side> sides;
  sides.reserve(4 * tets.size());
  for (Index t = 0; t < tets.size(); ++t) {
    const auto v = tets.facet(t);
    for (std::size_t i = 0; i < 4; ++i) {
      Side s{{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]}, t};
      std::ranges::sort(s.face);
      sides.push_back(s);
    }
  }
  std::ranges::sort(sides, {}, &Side::face);
  return sides;
}

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
  const std::vector<Side> sides = sides_of(a.tets);
  const auto in_soup = sorted_faces(a.faces);
  UnionFind parts(a.tets.size());
  Index outside = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool is_inside = i + 1 < sides.size() && sides[i].face == sides[i + 1].face;
    if (!is_inside) outside = sides[i].tet;
    if (is_inside && !std::ranges::binary_search(in_soup, sides[i].face))
      parts.join(sides[i].tet, sides[i + 1].tet);
    i += is_inside;
  }
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
