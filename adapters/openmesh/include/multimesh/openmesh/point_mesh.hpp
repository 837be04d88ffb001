// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/openmesh/connectivity.hpp"

namespace multimesh::openmesh {

/// Points: an OpenMesh connectivity that has only vertices. Each is a facet with a single dart, whose code is
/// the index of the vertex. There are no edges, so a relocation is the only operation that can be requested
/// here, and no operation removes a point. Vertex properties are values on the points.
class PointMesh final : public Connectivity {
 public:
  /// Takes ownership of a mesh. \throw InputError if it has edges or faces
  explicit PointMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om);

  Index capacity(int k) const override { return k == 0 ? static_cast<Index>(om_.n_vertices()) : 0; }
  bool is_live(int k, Index s) const override { return s < capacity(k) && !status(0)[s].deleted(); }
  bool is_dart(Dart d) const override { return is_live(0, code(d)); }
  Index simplex(Dart d, int) const override { return code(d); }
  Dart dart_of(int, Index s) const override { return Dart{s}; }
  Dart switch_dart(Dart, int) const override { return no_dart; }
  Dart reorder(Dart d, Permutation) const override { return d; }
  Permutation order(Dart, Dart) const override { return {}; }
  void vertices(Dart d, Index* out) const override { out[0] = code(d); }
  void star(Dart d, int, DartBuffer& out) const override { out.assign(1, d); }
  bool is_boundary(Dart, int) const override { return false; }
  void check(std::vector<std::string>& problems) const override;

  // Calls that need an edge. \throw UsageError
  bool link_condition(Dart) const override { refuse(); }
  void split_edge(Dart, SplitRecord&) override { refuse(); }
  void collapse_edge(Dart, CollapseRecord&) override { refuse(); }
  void collapse_region(Dart, CollapseRegion&) const override { refuse(); }
  Dart after_split(const SplitRecord&, Dart, End) const override { refuse(); }
  Dart after_collapse(const CollapseRecord&, Dart) const override { refuse(); }

 private:
  [[noreturn]] static void refuse();
};

}  // namespace multimesh::openmesh
