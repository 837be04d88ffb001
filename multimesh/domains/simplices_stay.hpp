// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "multimesh/invariant.hpp"

namespace multimesh {

/// The given facets of the meshes of a tree are neither split nor collapsed, and none of their vertices
/// moves, whichever mesh an operation is requested on. Cost: the stars of all copies
class SimplicesStay final : public Invariant {
 public:
  using Stays = std::function<bool(NodeId, Index facet)>;
  SimplicesStay(std::string name, Stays stays) : Invariant(std::move(name)), stays_(std::move(stays)) {}
  bool before(const Event& event) override;

 private:
  bool changes(const Event& event, const Copy& c);
  bool any_around(const Mesh& mesh, NodeId n, Dart d, int k);

  Stays stays_;
  DartBuffer star_;
};

}  // namespace multimesh
