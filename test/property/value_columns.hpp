// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "multimesh/column.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "test/property/value_model.hpp"

namespace multimesh::test {

/// Values of all kinds on all simplices of one mesh, stored in all of the library's ways: properties that
/// follow without a call, columns over properties, columns over plain vectors.
class ValueColumns {
 public:
  /// Random values on everything.
  ValueColumns(Propagation& operations, MultiMesh& tree, NodeId n, std::mt19937& random);

  /// All values, by vertex sets.
  ValueMesh read() const;
  /// Moves those in plain vectors, after a compaction.
  void follow(const Compaction& moved);

 private:
  struct OfKind {  // of simplex
    int k;
    std::vector<int> plain;
    std::vector<int>* carried = nullptr;
    std::vector<int>* larger = nullptr;
    std::vector<unsigned>* flags = nullptr;
    std::vector<double>* mean = nullptr;
    std::vector<double>* part = nullptr;

    Values at(std::size_t i) const;
    void fill(std::mt19937& random);
  };
  void add_to_openmesh(std::mt19937& random);
  void add_to_points(std::mt19937& random);
  void add_to_tetrahedra(std::mt19937& random);
  template <class T, template <class> class Handle>
  std::vector<T>& property(const char* name, bool left);
  template <class A, class... Arguments>
  void follow_by(Arguments&&... arguments);
  void read_openmesh(ValueMesh& out) const;
  void read_tetrahedra(ValueMesh& out) const;
  Values sparse(int k, Dart d) const;

  Propagation& operations_;
  Mesh& mesh_;
  NodeId node_;
  openmesh::Connectivity* openmesh_ = nullptr;
  tet::TetMesh* tets_ = nullptr;
  OfKind vertices_{0, {}}, edges_{1, {}}, facets_{2, {}}, corners_{corners, {}};
  std::vector<std::unique_ptr<std::vector<double>>> doubles_;
  std::vector<std::unique_ptr<Attribute>> attributes_;
  tet::SimplexProperty<int>* carried_sparse_[3] = {};
  tet::SimplexProperty<Values>* ruled_sparse_[3] = {};
};

}  // namespace multimesh::test
