// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "multimesh/event.hpp"

namespace multimesh {

/// Values on one mesh that follow the operations. Writes are undone with the transaction.
class Attribute {
 public:
  using Mark = std::size_t;
  explicit Attribute(NodeId node) : node_(node) {}
  virtual ~Attribute() = default;
  Attribute(const Attribute&) = delete;
  Attribute& operator=(const Attribute&) = delete;

  NodeId node() const noexcept { return node_; }
  /// Called once per copy and operation, after the connectivity of all meshes has changed, root first.
  virtual void update(Operation operation, const VertexChange& change) = 0;
  /// Called once per operation, after all updates: for values on other simplices than vertices (corners, edges).
  virtual void finish(const Event&) {}
  virtual Mark mark() const = 0;
  virtual void rollback(Mark mark) = 0;
  virtual void forget() = 0;

 private:
  NodeId node_;
};

/// Types with a weighted mean; others take the value of the nearer end.
template <class T>
concept Interpolable = !std::is_integral_v<T> && requires(const T& a) {
  T(a * 0.5 + a * 0.5);
};

/// A vertex attribute over a std::vector that grows with its mesh (an OpenMesh property's data_vector()).
/// The default rule interpolates: (1-t) a + t b at the new or merged vertex. Another rule may be given,
/// per attribute, for instance one that pulls the value from the parent's mesh:
///   [&](Operation, const VertexChange& c) { return parent_values[c.above]; }
/// A rule only reads: invariants ask it, by result(), what the vertex would get.
template <class T>
class VertexAttribute final : public Attribute {
 public:
  using Rule = std::function<T(Operation, const VertexChange&)>;

  VertexAttribute(NodeId node, std::vector<T>& values) : Attribute(node), values_(&values) {}
  VertexAttribute(NodeId node, std::vector<T>& values, Rule rule)
      : Attribute(node), values_(&values), rule_(std::move(rule)) {}

  const std::vector<T>& values() const noexcept { return *values_; }
  const T& operator[](Index v) const { return (*values_)[v]; }

  /// A journaled write; use it instead of writing to the vector inside transactions.
  void set(Index v, T value) {
    undo_.emplace_back(v, (*values_)[v]);
    (*values_)[v] = std::move(value);
  }

  /// What the new or merged vertex of a split or collapse gets; may be asked before it is done.
  T result(Operation operation, const VertexChange& c) const {
    return rule_ ? rule_(operation, c) : interpolated(c);
  }
  /// The default rule.
  T interpolated(const VertexChange& c) const {
    const Index same = c.t <= 0 ? c.a : c.t >= 1 ? c.b : no_index;
    if constexpr (Interpolable<T>) {
      if (same == no_index) return T((*values_)[c.a] * (1.0 - c.t) + (*values_)[c.b] * c.t);
    }
    return (*values_)[same != no_index ? same : c.t < 0.5 ? c.a : c.b];
  }

  void update(Operation operation, const VertexChange& c) override {
    if (rule_) return set(c.vertex, rule_(operation, c));
    if (operation == Operation::relocate || operation == Operation::flip) return;
    if ((c.t <= 0 ? c.a : c.t >= 1 ? c.b : no_index) == c.vertex) return;
    set(c.vertex, interpolated(c));
  }

  Mark mark() const override { return undo_.size(); }
  void rollback(Mark mark) override {
    while (undo_.size() > mark) {
      auto& [v, old] = undo_.back();
      if (v < values_->size()) (*values_)[v] = std::move(old);  // else it was popped with its vertex
      undo_.pop_back();
    }
  }
  void forget() override { undo_.clear(); }

 private:
  std::vector<T>* values_;
  Rule rule_;
  std::vector<std::pair<Index, T>> undo_;
};

}  // namespace multimesh
