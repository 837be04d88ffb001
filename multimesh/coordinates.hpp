// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "multimesh/attribute.hpp"
#include "multimesh/geometry/vector.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

/// Coordinates of the vertices of one mesh, in space or in the plane (then the third is 0), whatever type
/// they are stored in. Writes are rolled back with a transaction.
class Coordinates {
 public:
  virtual ~Coordinates() = default;
  virtual NodeId node() const = 0;
  virtual Vec3 at(Index v) const = 0;
  /// Other copies of the vertex in this mesh may move too: see place_of_copy.
  virtual void set(Index v, const Vec3& x) = 0;
  /// The place of another copy of v in this mesh when v is at x: also x, except in periodic tiles.
  virtual Vec3 place_of_copy(Index /*copy*/, Index /*v*/, const Vec3& x) const { return x; }
};

/// Coordinates that an attribute stores; it must outlive this object. `T`: a vector of two or three
/// components, OpenMesh's or Eigen's.
template <class T>
class CoordinatesOf final : public Coordinates {
 public:
  explicit CoordinatesOf(VertexAttribute<T>& values) : values_(values) {}
  NodeId node() const override { return values_.node(); }
  Vec3 at(Index v) const override {
    const T& x = values_[v];
    return {double(x[0]), double(x[1]), size == 2 ? 0 : double(x[size - 1])};
  }
  void set(Index v, const Vec3& x) override {
    T value = values_[v];
    for (unsigned i = 0; i < size; ++i) value[i] = static_cast<Real>(x[i]);
    values_.set(v, value);
  }

 private:
  static constexpr unsigned size = sizeof(T) / sizeof(std::declval<T&>()[0]);
  using Real = std::remove_cvref_t<decltype(std::declval<T&>()[0])>;
  static_assert((size == 2 || size == 3) && sizeof(T) == size * sizeof(Real));

  VertexAttribute<T>& values_;
};

/// Coordinates of a mesh that has none of its own, read through its map from a mesh above. They are cached
/// for fast reading. A write goes to the source, and the cache is updated with the operation. This attribute
/// must be among those of the operations, after the source's. Cost: linear, once.
class CoordinatesFromParent final : public Coordinates {
 public:
  /// `above`: the coordinates of the parent of n.
  CoordinatesFromParent(const MultiMesh& tree, NodeId n, Coordinates& above);
  NodeId node() const override { return node_; }
  Vec3 at(Index v) const override { return values_[v]; }
  /// Only as part of a relocation.
  void set(Index v, const Vec3& x) override;
  Vec3 place_of_copy(Index copy, Index v, const Vec3& x) const override;
  Attribute& attribute() { return attribute_; }

 private:
  Index above(Index v) const;

  const MultiMesh& tree_;
  NodeId node_;
  Coordinates& above_;
  std::vector<Vec3> values_;
  VertexAttribute<Vec3> attribute_;
};

}  // namespace multimesh
