// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/attribute.hpp"

namespace multimesh {

/// A scope in which everything done to the meshes, maps and attributes can be undone exactly: handles, status
/// bits, properties and element counts included. It rolls back unless committed, also on an exception. Scopes
/// nest; an outer one can still undo what an inner one has committed. Undoing costs as much as what was done.
/// `attributes` must be all that are written inside, by operations or otherwise; Propagation::transaction()
/// passes its own. \throw UsageError, also commit(), in the middle of an operation
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
