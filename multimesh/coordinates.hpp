// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
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

  /// In a periodic tile: all lattice vectors between it and its neighbours, but 0.
  virtual std::vector<Vec3> periods() const { return {}; }
  /// The point of the same place in the torus that is nearest to another point.
  virtual Vec3 image_near(const Vec3& x, const Vec3& /*point*/) const { return x; }
  /// Where the vertex may be instead of at x: the nearest such place. In a periodic tile whose sides stay
  /// flat, a vertex of a side stays in its plane.
  virtual Vec3 allowed(Index /*v*/, const Vec3& x) const { return x; }

  /// What at() gives after set(): of a type with fewer digits.
  virtual Vec3 rounded(const Vec3& x) const { return x; }
  /// The place that the merged vertex of a collapse will have.
  virtual Vec3 merged(const VertexChange& c) const = 0;
  /// Says where merged vertices go, by the changes of the mesh that stores the coordinates; nothing: as if it
  /// had not been asked. See PrescribedPlaces.
  using Places = std::function<std::optional<Vec3>(const VertexChange&)>;
  virtual void prescribe(Places places) = 0;
  /// The list in which they are stored, if its type is this one: see CoordinateList.
  virtual const std::vector<Vec3>* list(const Vec3*) const { return nullptr; }
  virtual const std::vector<Vec2>* list(const Vec2*) const { return nullptr; }
};

/// During its lifetime, an algorithm prescribes the places of merged vertices.
class PrescribedPlaces {
 public:
  PrescribedPlaces(Coordinates& of, Coordinates::Places places) : of_(of) { of.prescribe(std::move(places)); }
  ~PrescribedPlaces() { of_.prescribe({}); }
  PrescribedPlaces(const PrescribedPlaces&) = delete;
  PrescribedPlaces& operator=(const PrescribedPlaces&) = delete;

 private:
  Coordinates& of_;
};

/// Coordinates that an attribute stores; it must outlive this object. `T`: a vector of two or three
/// components, OpenMesh's or Eigen's.
template <class T>
class CoordinatesOf final : public Coordinates {
 public:
  explicit CoordinatesOf(VertexAttribute<T>& values) : values_(values) {}
  NodeId node() const override { return values_.node(); }
  Vec3 at(Index v) const override { return to_vec3(values_[v]); }
  void set(Index v, const Vec3& x) override { values_.set(v, from_vec3(x)); }
  Vec3 rounded(const Vec3& x) const override { return to_vec3(from_vec3(x)); }
  Vec3 merged(const VertexChange& c) const override {
    return to_vec3(values_.result(Operation::collapse, c));
  }
  void prescribe(Places places) override {
    if (!places) return values_.prescribe({});
    values_.prescribe([this, places = std::move(places)](const VertexChange& c) {
      const std::optional<Vec3> x = places(c);
      return x ? std::optional<T>(from_vec3(*x)) : std::nullopt;
    });
  }
  const std::vector<Vec3>* list(const Vec3*) const override { return list_of<Vec3>(); }
  const std::vector<Vec2>* list(const Vec2*) const override { return list_of<Vec2>(); }

 private:
  static Vec3 to_vec3(const T& x) {
    return {double(x[0]), double(x[1]), size == 2 ? 0 : double(x[size - 1])};
  }
  static T from_vec3(const Vec3& x) {
    T value{};
    for (unsigned i = 0; i < size; ++i) value[i] = static_cast<Real>(x[i]);
    return value;
  }
  template <class V>
  const std::vector<V>* list_of() const {
    if constexpr (std::is_same_v<T, V>) {
      return &values_.values();
    } else {
      return nullptr;
    }
  }

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
  std::vector<Vec3> periods() const override { return above_.periods(); }
  Vec3 image_near(const Vec3& x, const Vec3& p) const override { return above_.image_near(x, p); }
  Vec3 allowed(Index v, const Vec3& x) const override { return above_.allowed(above(v), x); }
  Vec3 rounded(const Vec3& x) const override { return above_.rounded(x); }
  /// As the mesh above has it, or will have it. \pre the change has its vertices there
  Vec3 merged(const VertexChange& c) const override { return above_.merged(c); }
  /// By the changes of the mesh that they come from.
  void prescribe(Places places) override { above_.prescribe(std::move(places)); }
  const std::vector<Vec3>* list(const Vec3*) const override { return &values_; }
  Attribute& attribute() { return attribute_; }

 private:
  Index above(Index v) const;

  const MultiMesh& tree_;
  NodeId node_;
  Coordinates& above_;
  std::vector<Vec3> values_;
  VertexAttribute<Vec3> attribute_;
};

/// Coordinates for loops that read them very often: the list in which they are stored, if it has this type;
/// else a copy that follows the operations. `V`: Vec3, or Vec2 for those in the plane. Both, and the mesh,
/// must outlive it. Cost: linear, if it is a copy
template <class V>
class CoordinateList {
 public:
  CoordinateList(const Coordinates& source, const Mesh& mesh, Propagation& operations)
      : values_(source.list(static_cast<const V*>(nullptr))) {
    if (values_ != nullptr) return;
    copy_.resize(mesh.capacity(0));
    for (Index v = 0; v < copy_.size(); ++v)
      if (mesh.is_live(0, v)) copy_[v] = read(source, v);
    attribute_.emplace(source.node(), copy_,
                       [&source](Operation, const VertexChange& c) { return read(source, c.vertex); });
    operations.add(*attribute_);
    values_ = &copy_;
  }
  CoordinateList(const CoordinateList&) = delete;
  CoordinateList& operator=(const CoordinateList&) = delete;

  const V& operator[](Index v) const { return (*values_)[v]; }
  /// The same list as long as this lives.
  const std::vector<V>& values() const noexcept { return *values_; }

 private:
  static V read(const Coordinates& source, Index v) {
    const Vec3 x = source.at(v);
    if constexpr (std::is_same_v<V, Vec2>) {
      return {x[0], x[1]};
    } else {
      return x;
    }
  }

  std::vector<V> copy_;
  std::optional<VertexAttribute<V>> attribute_;
  const std::vector<V>* values_;
};

}  // namespace multimesh
