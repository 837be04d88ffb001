// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "multimesh/invariant.hpp"

namespace multimesh {

/// The given facets of the meshes of a tree are neither split nor collapsed, and none of their vertices
/// moves, whichever mesh an operation is requested on. Cost: the stars of all copies
class SimplicesStay final : public Invariant {
 public:
  using Stays = std::function<bool(NodeId, Index facet)>;
  SimplicesStay(std::string name, Stays stays) : Invariant(std::move(name)), stays_(std::move(stays)) {}
  bool before(const Event& event) override;
  bool stays(NodeId n, Index facet) const { return stays_(n, facet); }

 private:
  bool changes(const Event& event, const Copy& c);
  bool any_around(const Mesh& mesh, NodeId n, Dart d, int k);

  Stays stays_;
  DartBuffer star_;
};

/// What an embedding keeps as it is, for those who would rather not ask for what will be refused (Strata).
struct Kept {
  std::vector<const SimplicesStay*> facets;
  /// Edges that some invariant keeps.
  std::vector<std::pair<NodeId, std::function<bool(Dart)>>> edges;
  /// Facets of different parts: the faces between them are walls.
  std::vector<std::pair<NodeId, const std::vector<std::int32_t>*>> parts;
};

}  // namespace multimesh
