// SPDX-License-Identifier: BSD-3-Clause
// A mesh type of your own behind the interface of the core: polylines in plain vectors. It is the simplest
// correct one: a search is a loop over all edges. This file has the darts and the operations.
#pragma once

#include <algorithm>
#include <string>

#include "own_mesh_storage.hpp"

/// Dart 2 e + i: edge e, from its end i.
class OwnMesh final : public OwnMeshStorage {
 public:
  explicit OwnMesh(std::vector<std::array<Index, 2>> edges) {
    for (const auto& e : edges)
      state_.vertices.resize(std::max({state_.vertices.size(), e[0] + 1UL, e[1] + 1UL}));
    for (const auto& e : edges) state_.vertices[e[0]] = state_.vertices[e[1]] = true;
    state_.edges = std::move(edges);
  }

  Index capacity(int k) const override {
    return Index(k == 0 ? state_.vertices.size() : state_.edges.size());
  }
  bool is_live(int k, Index s) const override {
    return s < capacity(k) && (k == 0 ? state_.vertices[s] : state_.edges[s][0] != multimesh::no_index);
  }
  bool is_dart(Dart d) const override { return is_live(1, code(d) / 2); }
  Index simplex(Dart d, int k) const override { return k == 0 ? end(d, 0) : code(d) / 2; }
  Dart dart_of(int k, Index s) const override { return k == 1 ? Dart{2 * s} : any_at(s); }
  Dart switch_dart(Dart d, int k) const override {
    return k == 0 ? Dart{code(d) ^ 1U} : other_at(end(d, 0), code(d) / 2);
  }
  Dart reorder(Dart d, Permutation p) const override { return Dart{code(d) ^ p.code}; }
  Permutation order(Dart x, Dart y) const override { return {std::uint8_t((code(x) ^ code(y)) & 1U)}; }
  void vertices(Dart d, Index* out) const override { out[0] = end(d, 0), out[1] = end(d, 1); }
  void star(Dart d, int k, multimesh::DartBuffer& out) const override {
    out.assign(1, d);
    if (const Dart other = switch_dart(d, 1); k == 0 && other != multimesh::no_dart) out.push_back(other);
  }
  bool is_boundary(Dart d, int) const override { return switch_dart(d, 1) == multimesh::no_dart; }
  // Not the last edge of a chain, nor one of the three of a loop.
  bool link_condition(Dart e) const override {
    const Dart at_a = switch_dart(e, 1), at_b = switch_dart(Dart{code(e) ^ 1U}, 1);
    if (at_a == multimesh::no_dart || at_b == multimesh::no_dart) return at_a != at_b;
    return end(at_a, 1) != end(at_b, 1);
  }
  void split_edge(Dart e, multimesh::SplitRecord& r) override {
    const Index old = code(e) / 2, fresh = capacity(1);
    r.a = end(e, 0), r.b = end(e, 1), r.vertex = capacity(0);
    r.at_a = Dart{2 * fresh};
    r.facets.assign(1, {old, fresh, old});
    r.words = {old, fresh, code(e) & 1U};
    state_.vertices.push_back(true);
    state_.edges[old][code(e) & 1U] = r.vertex;
    state_.edges.push_back({r.a, r.vertex});
    state_.anchors.resize(state_.edges.size());
    for (auto& l : state_.links) l.resize(state_.edges.size(), multimesh::no_index);
  }
  Dart after_split(const multimesh::SplitRecord& r, Dart d, multimesh::End end) const override {
    return code(d) / 2 != r.words[0] || end == multimesh::End::b
               ? d
               : Dart{2 * r.words[1] + ((code(d) ^ r.words[2]) & 1U)};
  }
  void collapse_edge(Dart e, multimesh::CollapseRecord& r) override {
    const Dart beyond = switch_dart(e, 1);
    r.dead = end(e, 0), r.survivor = end(e, 1);
    r.words = {code(e) / 2};
    state_.edges[code(e) / 2] = {multimesh::no_index, multimesh::no_index};
    state_.vertices[r.dead] = false;
    if (beyond != multimesh::no_dart) state_.edges[code(beyond) / 2][code(beyond) & 1U] = r.survivor;
    r.at_survivor = any_at(r.survivor);
  }
  void collapse_region(Dart e, multimesh::CollapseRegion& region) const override {
    region.dead.assign(1, e), region.renamed.clear();
  }
  Dart after_collapse(const multimesh::CollapseRecord& r, Dart d) const override {
    return code(d) / 2 == r.words[0] ? r.at_survivor : d;
  }

  void check(std::vector<std::string>& problems) const override {
    for (Index v = 0; v < capacity(0); ++v) {
      int edges = 0;
      for (const auto& e : state_.edges) edges += (e[0] == v) + (e[1] == v);
      if (edges > 2 || (edges > 0 && !is_live(0, v))) problems.push_back("vertex " + std::to_string(v));
    }
  }

 private:
  Index end(Dart d, unsigned other) const { return state_.edges[code(d) / 2][(code(d) & 1U) ^ other]; }
  /// A dart at v on another edge than this one.
  Dart other_at(Index v, Index edge) const {
    for (Index e = 0; e < state_.edges.size(); ++e)
      for (const unsigned i : {0U, 1U})
        if (e != edge && state_.edges[e][i] == v) return Dart{2 * e + i};
    return multimesh::no_dart;
  }
  Dart any_at(Index v) const { return other_at(v, multimesh::no_index); }
};
