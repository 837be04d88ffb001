// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "multimesh/event.hpp"

namespace multimesh {

/// Used in place of a dimension: values on the corners of facets.
inline constexpr int corners = -1;

/// Values on one mesh that follow the operations. Writes are undone with the transaction.
class Attribute {
 public:
  using Mark = std::size_t;
  /// `dimension`: that of the simplices that have the values, or `corners`.
  explicit Attribute(NodeId node, int dimension = 0) : node_(node), dimension_(dimension) {}
  virtual ~Attribute() = default;
  Attribute(const Attribute&) = delete;
  Attribute& operator=(const Attribute&) = delete;

  NodeId node() const noexcept { return node_; }
  int dimension() const noexcept { return dimension_; }
  /// The required number of values.
  std::size_t slots(const Mesh& mesh) const {
    return dimension_ == corners ? mesh.corner_capacity() : mesh.capacity(dimension_);
  }
  /// Whether finish() looks which of two values a collapse keeps (SimplexChange::second_wins).
  virtual bool needs_kept() const { return true; }
  /// Called once per copy and operation, root first, after the connectivity of all meshes has changed.
  virtual void update(Operation operation, const VertexChange& change) = 0;
  /// Called once per operation, after all updates: for values on simplices other than vertices (corners,
  /// edges).
  virtual void finish(const Event&) {}
  virtual Mark mark() const = 0;
  virtual void rollback(Mark mark) = 0;
  virtual void forget() = 0;

  /// \throw UsageError if there are fewer values than `slots`, or, with `exactly`, a different number.
  /// Called before each operation
  virtual void require_size(std::size_t /*slots*/, bool /*exactly*/ = false) const {}
  /// Grows to `slots` values. Called after the mesh has grown. Journaled
  virtual void grow(std::size_t /*slots*/) {}

 private:
  NodeId node_;
  int dimension_;
};

/// Values in a std::vector, one per slot of its kind of simplex, and their journal. The vector may be one
/// that grows and is compacted with its mesh (an OpenMesh property's data_vector()), or any other. Any other
/// vector grows with the operations; after MultiMesh::compact() or resync() the caller has to move its values
/// as those calls report, and to resize it, before the next operation.
template <class T>
class ValueAttribute : public Attribute {
 public:
  using Reference = typename std::vector<T>::const_reference;

  const std::vector<T>& values() const noexcept { return *values_; }
  Reference operator[](Index i) const { return (*values_)[i]; }

  /// A journaled write. Inside transactions, use it instead of writing to the vector.
  void set(Index i, T value) {
    undo_.emplace_back(i, T((*values_)[i]));
    (*values_)[i] = std::move(value);
  }

  Mark mark() const override { return undo_.size() + sizes_.size(); }
  void rollback(Mark mark) override {
    while (undo_.size() + sizes_.size() > mark) {
      if (!sizes_.empty() && sizes_.back().writes == undo_.size()) {
        values_->resize(sizes_.back().size);
        sizes_.pop_back();
        continue;
      }
      auto& [i, old] = undo_.back();
      if (i < values_->size()) (*values_)[i] = std::move(old);  // else it was popped with its simplex
      undo_.pop_back();
    }
  }
  void forget() override {
    undo_.clear();
    sizes_.clear();
  }

  void require_size(std::size_t slots, bool exactly) const override {
    if (values_->size() < slots || (exactly && values_->size() != slots)) refuse_size(slots);
  }
  void grow(std::size_t slots) override {
    if (values_->size() >= slots) return;
    sizes_.push_back({undo_.size(), values_->size()});
    values_->resize(slots);
  }

 protected:
  ValueAttribute(NodeId node, int dimension, std::vector<T>& values)
      : Attribute(node, dimension), values_(&values) {}

 private:
  [[noreturn]] void refuse_size(std::size_t slots) const {
    throw UsageError("an attribute of mesh " + std::to_string(index(node())) + " has " +
                     std::to_string(values_->size()) + " values, not " + std::to_string(slots) +
                     ", one per slot; where a mesh was compacted, move them as compact() tells");
  }

  std::vector<T>* values_;
  std::vector<std::pair<Index, T>> undo_;
  struct Resized {
    std::size_t writes, size;  // the vector grew from this size after so many writes
  };
  std::vector<Resized> sizes_;
};

/// Types with a weighted mean. Values of other types are taken from the nearer end.
template <class T>
concept Interpolable = !std::is_integral_v<T> && requires(const T& a) {
  T(a * 0.5 + a * 0.5);
};

/// (1-t) a + t b; the nearer of the two for types without a mean.
template <class T>
T interpolated(const T& a, const T& b, double t) {
  if (t <= 0 || t >= 1) return t <= 0 ? a : b;
  if constexpr (Interpolable<T>) {
    return T(a * (1.0 - t) + b * t);
  } else {
    return t < 0.5 ? a : b;
  }
}

/// A vertex attribute. The default rule interpolates: (1-t) a + t b at the new or merged vertex. Each
/// attribute may have another rule, for instance one that takes the value from the parent's mesh:
///   [&](Operation, const VertexChange& c) { return parent_values[c.above]; }
/// A rule must only read: invariants call it, through result(), to predict the vertex's value.
/// During its run, an algorithm may prescribe the values of merged vertices; they take precedence over rules.
template <class T>
class VertexAttribute final : public ValueAttribute<T> {
 public:
  using Rule = std::function<T(Operation, const VertexChange&)>;
  /// Of the merged vertex of a collapse; nothing: as the rule says.
  using Prescription = std::function<std::optional<T>(const VertexChange&)>;

  VertexAttribute(NodeId node, std::vector<T>& values, Rule rule = {})
      : ValueAttribute<T>(node, 0, values), rule_(std::move(rule)) {}

  /// The value that the new or merged vertex of a split or collapse gets. May be called before the operation.
  T result(Operation operation, const VertexChange& c) const {
    if (const auto prescribed = prescribed_value(operation, c)) return *prescribed;
    return rule_ ? rule_(operation, c) : interpolated(c);
  }
  /// The default rule.
  T interpolated(const VertexChange& c) const {
    return multimesh::interpolated<T>((*this)[c.a], (*this)[c.b], c.t);
  }

  /// Empty: none any more.
  void prescribe(Prescription values) { prescription_ = std::move(values); }

  void update(Operation operation, const VertexChange& c) override {
    if (const auto prescribed = prescribed_value(operation, c)) return this->set(c.vertex, *prescribed);
    if (rule_) return this->set(c.vertex, rule_(operation, c));
    if (operation == Operation::relocate || operation == Operation::flip) return;
    if ((c.t <= 0 ? c.a : c.t >= 1 ? c.b : no_index) == c.vertex) return;
    this->set(c.vertex, interpolated(c));
  }

 private:
  std::optional<T> prescribed_value(Operation operation, const VertexChange& c) const {
    return operation == Operation::collapse && prescription_ ? prescription_(c) : std::nullopt;
  }

  Rule rule_;
  Prescription prescription_;
};

}  // namespace multimesh
