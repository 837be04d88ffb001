// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// A named list of values of some type, one per slot of a kind of simplex, as its owning mesh sees it.
class ValueList {
 public:
  explicit ValueList(std::string name) : name_(std::move(name)) {}
  virtual ~ValueList() = default;
  ValueList& operator=(const ValueList&) = delete;

  const std::string& name() const noexcept { return name_; }

  /// Whether the values are in this std::vector.
  virtual bool are_in(const void* list) const = 0;
  virtual std::size_t size() const = 0;
  virtual void resize(std::size_t n) = 0;
  virtual void copy(Index from, Index to) = 0;
  virtual void swap(Index i, Index j) = 0;
  virtual void reset(Index i) = 0;    ///< to the value of a new slot
  virtual void save(Index i) = 0;     ///< pushes the value
  virtual void restore(Index i) = 0;  ///< pops it
  virtual void forget() = 0;          ///< the saved values
  /// Moves value i to place[i]; no_index: dropped.
  virtual void compact(const std::vector<Index>& place, std::size_t n) = 0;
  virtual std::unique_ptr<ValueList> clone() const = 0;

 protected:
  ValueList(const ValueList&) = default;

 private:
  std::string name_;
};

/// The initial value of a new slot (Eigen's types: zeros).
template <class T>
T initial_value() {
  if constexpr (requires { T::Zero(); }) {
    return T::Zero();
  } else {
    return T{};
  }
}

/// Values of one type. `values` has one entry per slot, dead ones included; new slots hold initial_value().
/// In transactions, write through a VertexAttribute or Column over `values`, or after Mesh::protect.
template <class T>
class ValuesOf final : public ValueList {
 public:
  using ValueList::ValueList;
  std::vector<T> values;

  const T& operator[](Index i) const { return values[i]; }
  T& operator[](Index i) { return values[i]; }

  bool are_in(const void* list) const override { return &values == list; }
  std::size_t size() const override { return values.size(); }
  void resize(std::size_t n) override { values.resize(n, initial_value<T>()); }
  void copy(Index from, Index to) override { values[to] = values[from]; }
  void swap(Index i, Index j) override { std::swap(values[i], values[j]); }
  void reset(Index i) override { values[i] = initial_value<T>(); }
  void save(Index i) override { saved_.push_back(values[i]); }
  void restore(Index i) override {
    values[i] = std::move(saved_.back());
    saved_.pop_back();
  }
  void forget() override { saved_.clear(); }
  void compact(const std::vector<Index>& place, std::size_t n) override {
    for (Index i = 0; i < place.size(); ++i)  // place[i] <= i
      if (place[i] != no_index && place[i] != i) values[place[i]] = std::move(values[i]);
    values.resize(n, initial_value<T>());
  }
  std::unique_ptr<ValueList> clone() const override { return std::make_unique<ValuesOf>(*this); }

 private:
  std::vector<T> saved_;
};

}  // namespace multimesh
