// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>

#include "multimesh/attribute.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

/// Coordinates of the vertices of one mesh, in space or (the third is 0) in the plane, whatever type they are
/// stored in; the writes are undone with a transaction.
class Coordinates {
 public:
  virtual ~Coordinates() = default;
  virtual NodeId node() const = 0;
  virtual OpenMesh::Vec3d at(Index v) const = 0;
  virtual void set(Index v, const OpenMesh::Vec3d& x) = 0;
};

/// Those of an attribute, which must outlive it. `T`: a vector of two or three components.
template <class T>
class CoordinatesOf final : public Coordinates {
 public:
  explicit CoordinatesOf(VertexAttribute<T>& values) : values_(values) {}
  NodeId node() const override { return values_.node(); }
  OpenMesh::Vec3d at(Index v) const override {
    const T& x = values_[v];
    if constexpr (T::size_ == 2)
      return {double(x[0]), double(x[1]), 0};
    else
      return {double(x[0]), double(x[1]), double(x[2])};
  }
  void set(Index v, const OpenMesh::Vec3d& x) override {
    using Real = typename T::value_type;
    if constexpr (T::size_ == 2)
      values_.set(v, T(static_cast<Real>(x[0]), static_cast<Real>(x[1])));
    else
      values_.set(v, T(static_cast<Real>(x[0]), static_cast<Real>(x[1]), static_cast<Real>(x[2])));
  }

 private:
  VertexAttribute<T>& values_;
};

}  // namespace multimesh
