// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/transaction.hpp"

namespace multimesh {

Transaction::Transaction(MultiMesh& tree, std::span<Attribute* const> attributes)
    : Transaction(tree, attributes, Own::no) {}

Transaction::Transaction(MultiMesh& tree, std::span<Attribute* const> attributes, Own own)
    : tree_(tree), attributes_(attributes), own_(own) {
  if (own == Own::no) tree.require_idle("a transaction");
  const std::size_t marks = tree.top_down_.size() + attributes.size();
  if (marks > in_place) more_marks_.resize(marks - in_place);
  std::size_t i = 0;
  for (const NodeId n : tree.top_down_) mark(i++) = tree.mesh(n).mark();
  for (const Attribute* a : attributes) mark(i++) = a->mark();
  ++tree.open_transactions_;
}

Transaction::~Transaction() {
  if (!open_) return;
  // Meshes first: vertices that are popped need no old value.
  std::size_t i = 0;
  for (const NodeId n : tree_.top_down_) tree_.mesh(n).rollback(mark(i++));
  for (Attribute* a : attributes_) a->rollback(mark(i++));
  --tree_.open_transactions_;
}

void Transaction::commit() {
  if (own_ == Own::no) tree_.require_idle("the end of a transaction");
  open_ = false;
  if (--tree_.open_transactions_ > 0) return;
  for (const NodeId n : tree_.top_down_) tree_.mesh(n).forget();
  for (Attribute* a : attributes_) a->forget();
}

}  // namespace multimesh
