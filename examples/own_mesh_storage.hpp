// SPDX-License-Identifier: BSD-3-Clause
// What a mesh stores for the core: its elements, anchors towards a parent, links towards children, and a
// journal of all of these. Here the journal keeps copies, and undoing is an assignment.
#pragma once

#include <array>
#include <vector>

#include "multimesh/mesh.hpp"

class OwnMeshStorage : public multimesh::Mesh {
 public:
  using Index = multimesh::Index;
  using Dart = multimesh::Dart;
  using Permutation = multimesh::Permutation;

  Mark mark() const override { return saved_.push_back(state_), saved_.size() - 1; }
  void rollback(Mark m) override { state_ = saved_[m], saved_.resize(m + 1); }
  void forget() override { saved_.clear(); }
  void protect(int, Index) override {}  // there are no properties

  void add_anchors() override { state_.anchors.resize(state_.edges.size()); }
  void remove_anchors() override { state_.anchors.clear(); }
  multimesh::Anchor anchor(Index f) const override { return state_.anchors[f]; }
  void set_anchor(Index f, multimesh::Anchor a) override { state_.anchors[f] = a; }
  LinkSet add_links(int) override {  // of edges: only polylines lie over polylines
    state_.links.emplace_back(state_.edges.size(), multimesh::no_index);
    return static_cast<LinkSet>(state_.links.size() - 1);
  }
  void remove_links(LinkSet l) override { state_.links[l].clear(); }
  Index link(LinkSet l, Dart d) const override { return state_.links[l][code(d) / 2]; }
  void set_link(LinkSet l, Dart d, Index f) override { state_.links[l][code(d) / 2] = f; }
  void remap_links(LinkSet l, const std::vector<Index>& moved) override {
    for (Index& f : state_.links[l])
      if (f != multimesh::no_index) f = moved[f];
  }

  multimesh::Compaction compact() override {
    const std::array<Index, 2> dead{multimesh::no_index, multimesh::no_index};
    multimesh::Compaction moved;
    moved.simplices.assign(2, {});
    State now;
    for (const bool live : state_.vertices) {
      moved.simplices[0].push_back(live ? static_cast<Index>(now.vertices.size()) : multimesh::no_index);
      if (live) now.vertices.push_back(true);
    }
    now.links.resize(state_.links.size());
    for (std::size_t e = 0; e < state_.edges.size(); ++e) {
      const auto [a, b] = state_.edges[e];
      moved.simplices[1].push_back(state_.edges[e] == dead ? multimesh::no_index
                                                           : static_cast<Index>(now.edges.size()));
      if (state_.edges[e] == dead) continue;
      now.edges.push_back({moved.simplices[0][a], moved.simplices[0][b]});
      if (!state_.anchors.empty()) now.anchors.push_back(state_.anchors[e]);
      for (std::size_t l = 0; l < state_.links.size(); ++l)
        if (!state_.links[l].empty()) now.links[l].push_back(state_.links[l][e]);
    }
    moved.blocks = moved.simplices[1];
    moved.block_bits = 1;
    state_ = std::move(now);
    return moved;
  }

 protected:
  OwnMeshStorage() : Mesh(1) {}

  struct State {
    std::vector<bool> vertices;               // which are live
    std::vector<std::array<Index, 2>> edges;  // their ends; no_index: dead
    std::vector<multimesh::Anchor> anchors;   // per edge, while there is a parent
    std::vector<std::vector<Index>> links;    // per set and edge
  };
  State state_;

 private:
  mutable std::vector<State> saved_;
};
