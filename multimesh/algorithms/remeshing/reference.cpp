// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/reference.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

Reference::Reference(const EmbeddedMesh& surface, Strata& strata, std::vector<Index>& patch,
                     std::vector<Index>& line)
    : tree_(surface.tree()),
      node_(surface.node()),
      mesh_(surface.mesh()),
      positions_(surface.positions()),
      below_(surface.charts()),
      strata_(strata) {
  number_patches(patch);
  number_lines(line);
  add_triangles(patch);
  add_segments(line);
  triangles_.emplace(std::move(patches_.triangles));
  if (!lines_.group.empty()) segments_.emplace(std::move(lines_.triangles));
}

// Faces that are joined by plain edges.
void Reference::number_patches(std::vector<Index>& patch) {
  std::fill(patch.begin(), patch.end(), no_index);
  DartBuffer waiting;
  Index n = 0;
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f) || patch[f] != no_index) continue;
    patch[f] = n;
    waiting.push_back(mesh_.dart_of(2, f));
    while (!waiting.empty()) {
      const Dart t = waiting.back();
      waiting.pop_back();
      for (const Permutation side : {Permutation{}, edge_ax, edge_bx}) {
        const Dart e = mesh_.reorder(t, side);
        const Dart beyond = mesh_.switch_dart(e, 2);
        if (beyond == no_dart || patch[mesh_.facet(beyond)] != no_index || !strata_.is_plain(e)) continue;
        patch[mesh_.facet(beyond)] = n;
        waiting.push_back(beyond);
      }
    }
    ++n;
  }
}

// Edges with a kind that are joined by vertices that may go along them.
void Reference::number_lines(std::vector<Index>& line) {
  std::fill(line.begin(), line.end(), 0);
  DartBuffer waiting;
  Index n = 0;
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e) || line[e] != 0 || strata_.is_plain(mesh_.dart_of(1, e))) continue;
    line[e] = ++n;
    waiting.push_back(mesh_.dart_of(1, e));
    while (!waiting.empty()) {
      const Dart d = waiting.back();
      waiting.pop_back();
      for (const Dart end : {d, mesh_.reorder(d, exchange_ends)}) {
        std::array<Dart, 2> two{};
        if (strata_.freedom(end, two) != Freedom::line) continue;
        for (const Dart next : two)
          if (Index& known = line[mesh_.simplex(next, 1)]; known == 0) known = n, waiting.push_back(next);
      }
    }
  }
}

// The k-simplex of d with everything that the meshes below have over it.
void Reference::add(Layer& layer, Dart d, int k, Index group) {
  std::array<Index, 4> v{};
  mesh_.vertices(d, v.data());
  const auto corner = [&](std::size_t i) { return i > static_cast<std::size_t>(k) ? std::size_t(k) : i; };
  const std::array<Vec3, 3> p{positions_.at(v[0]), positions_.at(v[1]), positions_.at(v[corner(2)])};
  layer.triangles.push_back({p[0], p[1], p[2]});
  layer.group.push_back(group);
  layer.normal.push_back(cross(p[1] - p[0], p[2] - p[0]));
  DartBuffer copies;
  for (std::size_t m = 0; m < below_.size(); ++m) {
    const NodeId n = below_[m]->node();
    copies.clear();
    tree_.to_descendant(node_, d, k, n, copies);
    for (const Dart c : copies) {
      tree_.mesh(n).vertices(c, v.data());
      layer.below.push_back({m, {below_[m]->at(v[0]), below_[m]->at(v[1]), below_[m]->at(v[corner(2)])}});
    }
  }
  layer.begin.push_back(static_cast<std::uint32_t>(layer.below.size()));
}

void Reference::add_triangles(std::vector<Index>& patch) {
  for (Index f = 0; f < mesh_.capacity(2); ++f)
    if (mesh_.is_live(2, f)) add(patches_, mesh_.dart_of(2, f), 2, patch[f]);
}

void Reference::add_segments(std::vector<Index>& line) {
  for (Index e = 0; e < mesh_.capacity(1); ++e)
    if (mesh_.is_live(1, e) && line[e] != 0) add(lines_, mesh_.dart_of(1, e), 1, line[e]);
}

Place Reference::place(const Layer& layer, const spatial::TriangleTree& tree, const spatial::Nearby& found) {
  const auto& w = found.barycentric;
  const Vec3 p = spatial::at(tree.triangles()[found.facet], w);
  Place result{{p[0], p[1], p[2]}, {}};
  for (std::uint32_t i = layer.begin[found.facet]; i < layer.begin[found.facet + 1]; ++i) {
    const Values& x = layer.below[i];
    result.below.push_back({x.mesh, x.at[0] * w[0] + x.at[1] * w[1] + x.at[2] * w[2]});
  }
  return result;
}

// Without a bound, many triangles of other groups may be asked before the first one of this group.
template <class Look>
std::optional<Place> Reference::closest(const Layer& layer, const spatial::TriangleTree& tree, Index group,
                                        const Vec3& p, double expected, Look look) {
  const Vec3& at = p;
  const spatial::TriangleTree::Choose choose = [&](Index f) -> std::optional<spatial::PointOnTriangle> {
    if (layer.group[f] != group || !look(f)) return std::nullopt;
    return spatial::closest_point(at, tree.triangles()[f]);
  };
  auto found = tree.nearest_chosen(at, choose, expected);
  if (!found) found = tree.nearest_chosen(at, choose);
  if (!found) return std::nullopt;
  return place(layer, tree, *found);
}

std::optional<Place> Reference::on_patch(Index patch, const Vec3& p, const Vec3& normal,
                                         double expected) const {
  return closest(patches_, *triangles_, patch, p, expected,
                 [&](Index f) { return dot(patches_.normal[f], normal) >= 0; });
}

std::optional<Place> Reference::on_line(Index line, const Vec3& p, double expected) const {
  if (!segments_) return std::nullopt;
  return closest(lines_, *segments_, line, p, expected, [](Index) { return true; });
}

}  // namespace multimesh::remeshing
