// SPDX-License-Identifier: BSD-3-Clause
#include "test/fuzz/script.hpp"

#include <memory>
#include <optional>
#include <vector>

#include "multimesh/permutation.hpp"
#include "test/support/fingerprint.hpp"
#include "test/support/storm.hpp"

namespace multimesh::test {

namespace {

constexpr std::size_t most_facets = 400;  // of the root, dead ones included, until it is compacted
constexpr std::size_t most_scopes = 4;

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return next_ >= bytes_.size(); }
  std::uint8_t next() { return empty() ? std::uint8_t{0} : bytes_[next_++]; }
  std::size_t below(std::size_t n) { return next() % n; }
  std::size_t wide() { return next() | static_cast<std::size_t>(next()) << 8; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// Thrown at a stage of an operation.
struct Injected {};

class Script {
 public:
  explicit Script(Bytes& bytes);
  ScriptResult run();

 private:
  /// An open transaction, and the tree when it was opened.
  struct Scope {
    Transaction transaction;
    std::vector<std::uint64_t> before;
  };

  void step();
  void operate(std::size_t choice);
  Outcome operation(std::size_t choice, NodeId n, Dart d);
  void close(bool keep);
  std::optional<Dart> some_dart(NodeId n);
  void check();
  void expect_unchanged(const std::vector<std::uint64_t>& before, const char* what);

  Bytes& bytes_;
  ScriptResult result_;
  std::unique_ptr<Tree> tree_;
  std::optional<Storm> checks_;
  bool refuse_before_ = false, refuse_after_ = false;
  FunctionInvariant refusal_;
  std::vector<std::unique_ptr<Scope>> scopes_;
};

Script::Script(Bytes& bytes)
    : bytes_(bytes),
      refusal_(
          "of the script", [this](const Event&) { return !refuse_before_; },
          [this](const Event&) { return !refuse_after_; }) {
  const auto& kinds = tree_kinds();
  const TreeKind& kind = kinds[bytes_.below(kinds.size())];
  const unsigned seed = bytes_.next();
  const std::size_t options = bytes_.next();
  tree_ = kind.make(16 + 8 * static_cast<Index>(options >> 4), seed);
  tree_->operations->add(refusal_);
  if (options & 1) tree_->operations->set({.contact = true});
  tree_->operations->protect_properties(options & 2);
  checks_.emplace(*tree_, 0U, Index{0}, Index{0});
}

ScriptResult Script::run() {
  check();
  while (result_.fault.empty() && !bytes_.empty()) {
    ++result_.steps;
    step();
    if (result_.fault.empty()) check();
  }
  while (result_.fault.empty() && !scopes_.empty()) close(false);
  while (!scopes_.empty()) scopes_.pop_back();  // the inner ones first
  return result_;
}

void Script::check() {
  if (const std::string fault = checks_->fault(); !fault.empty())
    result_.fault = "step " + std::to_string(result_.steps) + ": " + fault;
}

void Script::expect_unchanged(const std::vector<std::uint64_t>& before, const char* what) {
  if (fingerprint(*tree_) != before)
    result_.fault = "step " + std::to_string(result_.steps) + ": " + what + " left something changed";
}

void Script::step() {
  const std::size_t choice = bytes_.below(16);
  if (choice < 11) {
    operate(choice);
  } else if (choice < 13) {
    if (scopes_.size() < most_scopes)
      scopes_.push_back(
          std::unique_ptr<Scope>(new Scope{tree_->operations->transaction(), fingerprint(*tree_)}));
  } else if (choice < 15) {
    if (!scopes_.empty()) close(choice == 13);
  } else if (scopes_.empty()) {
    tree_->tree->compact();
  }
}

void Script::close(bool keep) {
  if (keep) scopes_.back()->transaction.commit();
  const auto before = std::move(scopes_.back()->before);
  scopes_.pop_back();
  if (!keep) expect_unchanged(before, "a transaction that was rolled back");
}

std::optional<Dart> Script::some_dart(NodeId n) {
  const Mesh& mesh = tree_->tree->mesh(n);
  const int d = mesh.dimension();
  const Index slots = mesh.capacity(d);
  auto f = static_cast<Index>(bytes_.wide() % slots);
  for (Index tried = 0; !mesh.is_live(d, f); f = (f + 1) % slots)
    if (++tried > slots) return std::nullopt;
  return mesh.reorder(mesh.dart_of(d, f), {static_cast<std::uint8_t>(bytes_.below(number_of_orders(d)))});
}

// The first byte after the choice: how it is disturbed, and on which mesh it is requested.
void Script::operate(std::size_t choice) {
  const auto nodes = tree_->tree->nodes();
  const std::size_t disturbed = bytes_.below(8);
  const NodeId n = nodes[bytes_.below(nodes.size())];
  const std::optional<Dart> d = some_dart(n);
  if (!d) return;
  refuse_before_ = disturbed == 5;
  refuse_after_ = disturbed == 6;
  Propagation& ops = *tree_->operations;
  if (disturbed == 7)
    ops.on_stage = [at = static_cast<int>(bytes_.below(12))](int stage) {
      if (stage == at) throw Injected();
    };
  const auto before = fingerprint(*tree_);
  bool done = false;
  try {
    done = bool(operation(choice, n, *d));
  } catch (const Injected&) {
  }
  ops.on_stage = {};
  ++(done ? result_.done : result_.refused);
  if (!done) expect_unchanged(before, "an operation that was refused");
}

Outcome Script::operation(std::size_t choice, NodeId n, Dart d) {
  Propagation& ops = *tree_->operations;
  const Mesh& root = tree_->tree->mesh(NodeId::root);
  const int dimension = tree_->tree->mesh(n).dimension();
  if (dimension == 0) choice = 10;  // points can only be moved
  if (choice < 4 && root.capacity(root.dimension()) < most_facets)
    return choice < 3 ? ops.split(n, d, 0.25 * static_cast<double>(1 + bytes_.below(3)))
                      : ops.split_simplex(n, d, 1 + static_cast<int>(bytes_.below(std::size_t(dimension))));
  if (choice < 8) {
    const std::size_t where = bytes_.below(12);
    const Placement place = where == 9    ? Placement::keep_a()
                            : where == 10 ? Placement::keep_b()
                                          : Placement::at(0.125 * static_cast<double>(where % 9));
    return ops.collapse(n, d, place);
  }
  if (choice == 8) return ops.swap(n, d);
  if (choice == 9) return bytes_.below(2) ? ops.swap_face(n, d) : ops.swap_by_split_and_collapse(n, d);
  return tree_->move(n, d, Point3(0.125 * static_cast<double>(bytes_.below(9)), 0.0, 0.0));
}

}  // namespace

ScriptResult run_script(std::span<const std::uint8_t> bytes) {
  Bytes reader(bytes);
  try {
    return Script(reader).run();
  } catch (const std::exception& e) {
    return {std::string("exception: ") + e.what()};
  }
}

}  // namespace multimesh::test
