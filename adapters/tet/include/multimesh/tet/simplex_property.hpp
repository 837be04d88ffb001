// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "multimesh/tet/simplex_table.hpp"

namespace multimesh::tet {

/// A named column on few of the edges or faces of a TetMesh. Simplices that come from the same simplex share
/// a value until it is written.
class SimplexPropertyBase {
 public:
  SimplexPropertyBase(int k, std::string name, std::size_t vertices)
      : name_(std::move(name)), table_(k, vertices) {}
  virtual ~SimplexPropertyBase() = default;
  SimplexPropertyBase(const SimplexPropertyBase&) = delete;
  SimplexPropertyBase& operator=(const SimplexPropertyBase&) = delete;

  const std::string& name() const noexcept { return name_; }
  int dimension() const noexcept { return table_.k(); }
  std::size_t size() const noexcept { return table_.map().size(); }

 protected:
  friend class TetMesh;
  /// Removes values that no simplex has. \return old to new numbers
  virtual std::vector<Index> compact() = 0;
  /// The number of the value of two simplices that become one; `share`: the part of `other` in it.
  virtual Index merged(Index kept, Index other, double share) = 0;

  SimplexTable& table() noexcept { return table_; }
  const SimplexTable& table() const noexcept { return table_; }

 private:
  std::string name_;
  SimplexTable table_;
};

template <class T>
class SimplexProperty final : public SimplexPropertyBase {
 public:
  /// Like ColumnRules::merge.
  using Merge = std::function<T(const T& kept, const T& other, double share)>;
  SimplexProperty(int k, std::string name, std::size_t vertices, Merge merge = {})
      : SimplexPropertyBase(k, std::move(name), vertices), merge_(std::move(merge)) {}

 private:
  friend class TetMesh;

  Index merged(Index kept, Index other, double share) override {
    if (!merge_ || kept == other) return kept;
    values_.push_back(merge_(values_[kept], values_[other], share));
    return static_cast<Index>(values_.size() - 1);
  }

  std::vector<Index> compact() override {
    std::vector<Index> number(values_.size(), no_index);
    std::vector<T> kept;
    table().map().for_each([&](const SimplexKey&, Index n) {
      if (number[n] != no_index) return;
      number[n] = static_cast<Index>(kept.size());
      kept.push_back(std::move(values_[n]));
    });
    values_ = std::move(kept);
    return number;
  }

  Merge merge_;
  std::vector<T> values_;
};

}  // namespace multimesh::tet
