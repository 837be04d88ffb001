// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/attribute.hpp"

namespace multimesh {

/// A scope in which everything done to the meshes, maps and attributes can be undone exactly: handles,
/// status bits, properties and element counts included. Undone when the scope ends without commit(), also
/// by an exception. Scopes nest; what an inner one committed, an outer one can still undo. Cost of undoing:
/// that of what was done. `attributes` must be all those that are written inside, by operations or otherwise;
/// Propagation::transaction() gives its own. \throw UsageError, also commit(), in the middle of an operation
class Transaction {
 public:
  Transaction(MultiMesh& tree, std::span<Attribute* const> attributes);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  friend class Propagation;
  enum class Own : bool { no, yes };  ///< of an operation
  Transaction(MultiMesh& tree, std::span<Attribute* const> attributes, Own own);

  MultiMesh& tree_;
  std::span<Attribute* const> attributes_;
  // Marks of the meshes (in top-down order), then of the attributes; few, so kept in place.
  static constexpr std::size_t in_place = 12;
  std::size_t marks_[in_place];
  std::vector<std::size_t> more_marks_;
  bool open_ = true;
  Own own_;

  std::size_t& mark(std::size_t i) { return i < in_place ? marks_[i] : more_marks_[i - in_place]; }
};

}  // namespace multimesh
