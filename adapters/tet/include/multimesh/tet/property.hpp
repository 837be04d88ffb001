// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh::tet {

/// A named column of values on the vertices or tetrahedra of a TetMesh, as the mesh sees it: it grows with
/// the mesh, new tetrahedra of a split copy the old one's value, and values can be saved for undo.
class PropertyBase {
 public:
  explicit PropertyBase(std::string name) : name_(std::move(name)) {}
  virtual ~PropertyBase() = default;
  PropertyBase(const PropertyBase&) = delete;
  PropertyBase& operator=(const PropertyBase&) = delete;

  const std::string& name() const noexcept { return name_; }

 protected:
  friend class TetMesh;
  virtual void resize(std::size_t n) = 0;
  virtual void copy(Index from, Index to) = 0;
  virtual void reset(Index i) = 0;    ///< to T{}
  virtual void save(Index i) = 0;     ///< pushes the value
  virtual void restore(Index i) = 0;  ///< pops it
  virtual void forget() = 0;
  /// Moves value i to place[i]; no_index: dropped.
  virtual void compact(const std::vector<Index>& place, std::size_t n) = 0;

 private:
  std::string name_;
};

/// Values of one type. `values` has one entry per slot, dead ones included; new slots hold T{} (Eigen's
/// types: zeros). In transactions, write through a VertexAttribute over `values`, or after
/// Mesh::protect.
template <class T>
class Property final : public PropertyBase {
 public:
  using PropertyBase::PropertyBase;
  std::vector<T> values;

  const T& operator[](Index i) const { return values[i]; }
  T& operator[](Index i) { return values[i]; }

 private:
  static T initial() {
    if constexpr (requires { T::Zero(); }) {
      return T::Zero();
    } else {
      return T{};
    }
  }

  void resize(std::size_t n) override { values.resize(n, initial()); }
  void copy(Index from, Index to) override { values[to] = values[from]; }
  void reset(Index i) override { values[i] = initial(); }
  void save(Index i) override { saved_.push_back(values[i]); }
  void restore(Index i) override {
    values[i] = std::move(saved_.back());
    saved_.pop_back();
  }
  void forget() override { saved_.clear(); }
  void compact(const std::vector<Index>& place, std::size_t n) override {
    for (Index i = 0; i < place.size(); ++i)  // place[i] <= i
      if (place[i] != no_index && place[i] != i) values[place[i]] = std::move(values[i]);
    values.resize(n, initial());
  }

  std::vector<T> saved_;
};

}  // namespace multimesh::tet
