// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/surface_topology.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

#include "multimesh/hash.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

class Joined {
 public:
  explicit Joined(const TexturedSurface& s)
      : surface_(s),
        root_(s.tree().mesh(NodeId::root)),
        has_copies_(s.cut_report().copied_vertices > 0),
        one_of_(root_.capacity(0), no_index),
        pieces_(root_.capacity(0)),
        rim_(root_.capacity(0)),
        on_rim_(root_.capacity(0), false) {}

  SurfaceTopology run() {
    add_faces();
    for (Index e = 0, end = root_.capacity(1); e < end; ++e)
      if (root_.is_live(1, e)) add_edge(root_.dart_of(1, e));
    add_shared_edges();
    for (Index v = 0; v < one_of_.size(); ++v) {
      if (one_of_[v] != v) continue;
      ++result_.vertices;
      result_.components += pieces_.find(v) == v;
      result_.boundary_loops += on_rim_[v] && rim_.find(v) == v;
    }
    result_.euler_characteristic = long(result_.vertices) - long(result_.edges) + long(result_.faces);
    for (std::size_t set = 0; set < surface_.textures().size(); ++set) add_closed_seams(set);
    return result_;
  }

 private:
  struct Edge {
    Index a, b;
    int faces;
  };

  void add_faces() {
    std::array<Index, 4> v{};
    for (Index f = 0, end = root_.capacity(2); f < end; ++f) {
      if (!root_.is_live(2, f)) continue;
      ++result_.faces;
      root_.vertices(root_.dart_of(2, f), v.data());
      for (std::size_t i = 0; i < 3; ++i)
        if (one_of_[v[i]] == no_index) one_of_[v[i]] = first_at_place(v[i]);
      pieces_.join(one_of_[v[0]], one_of_[v[1]]);
      pieces_.join(one_of_[v[1]], one_of_[v[2]]);
    }
  }

  /// Copies at one place get the number of the first of them.
  Index first_at_place(Index v) {
    if (!is_copy(v)) return v;
    const auto& p = surface_.positions()[v];
    const auto bits = [&](std::size_t k) { return std::bit_cast<std::uint64_t>(p[k]); };
    return first_copy_.try_emplace({surface_.source_positions()[v], bits(0), bits(1), bits(2)}, v)
        .first->second;
  }

  bool is_copy(Index v) const { return has_copies_ && surface_.is_copy(v); }

  void add_edge(Dart e) {
    const int faces = root_.is_boundary(e, 1) ? 1 : 2;
    if (faces == 2 && !has_copies_) {
      ++result_.edges;
      return;
    }
    const Index v = root_.vertex(e), w = root_.vertex(root_.switch_dart(e, 0));
    const Edge edge{std::min(one_of_[v], one_of_[w]), std::max(one_of_[v], one_of_[w]), faces};
    if (is_copy(v) || is_copy(w))
      may_be_shared_.push_back(edge);
    else
      add(edge);
  }

  void add(const Edge& e) {
    ++result_.edges;
    result_.crowded_edges += e.faces > 2;
    if (e.faces != 1) return;
    on_rim_[e.a] = on_rim_[e.b] = true;
    rim_.join(e.a, e.b);
  }

  void add_shared_edges() {
    auto& list = may_be_shared_;
    std::sort(list.begin(), list.end(),
              [](const Edge& x, const Edge& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    for (std::size_t i = 0, j; i < list.size(); i = j) {
      Edge all = list[i];
      for (j = i + 1; j < list.size() && list[j].a == all.a && list[j].b == all.b; ++j)
        all.faces += list[j].faces;
      add(all);
    }
  }

  void add_closed_seams(std::size_t set) {
    const NodeId node = surface_.textures()[set];
    const Mesh& texture = surface_.tree().mesh(node);
    const auto& values = surface_.texcoords(set);
    DartBuffer sides;
    std::size_t closed = 0;  // both sides are counted
    for (Index e = 0, end = texture.capacity(1); e < end; ++e) {
      if (!texture.is_live(1, e) || !texture.is_boundary(texture.dart_of(1, e), 1)) continue;
      sides.clear();
      surface_.tree().to_child(node, surface_.tree().to_parent(node, texture.dart_of(1, e)), 1, sides);
      if (sides.size() != 2) continue;
      const auto near = [&](std::size_t i) { return values[texture.vertex(sides[i])]; };
      const auto far = [&](std::size_t i) {
        return values[texture.vertex(texture.switch_dart(sides[i], 0))];
      };
      closed += near(0) == near(1) && far(0) == far(1);
    }
    result_.closed_seams += closed / 2;
  }

  const TexturedSurface& surface_;
  const Mesh& root_;
  bool has_copies_;
  std::vector<Index> one_of_;  // per vertex: the one that represents it; no_index: it has no face
  std::unordered_map<std::array<std::uint64_t, 4>, Index, ArrayHash> first_copy_;
  UnionFind pieces_, rim_;
  std::vector<bool> on_rim_;
  std::vector<Edge> may_be_shared_;
  SurfaceTopology result_;
};

}  // namespace

SurfaceTopology topology_of(const TexturedSurface& surface) {
  return Joined(surface).run();
}

std::vector<std::string> differences(const SurfaceTopology& before, const SurfaceTopology& after) {
  std::vector<std::string> list;
  const auto compare = [&](const char* what, long was, long is) {
    if (was != is)
      list.push_back(std::string(what) + ": " + std::to_string(was) + " became " + std::to_string(is));
  };
  compare("components", long(before.components), long(after.components));
  compare("Euler characteristic", before.euler_characteristic, after.euler_characteristic);
  compare("boundary loops", long(before.boundary_loops), long(after.boundary_loops));
  compare("edges with three or more faces", long(before.crowded_edges), long(after.crowded_edges));
  if (after.closed_seams > before.closed_seams)
    compare("closed seam edges", long(before.closed_seams), long(after.closed_seams));
  return list;
}

}  // namespace multimesh
