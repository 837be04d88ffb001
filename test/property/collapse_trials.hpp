// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "oracle/image_signature.hpp"
#include "oracle/random_trees.hpp"
#include "property/oracle_tree.hpp"

namespace multimesh::test {

/// A collapse as decided by the library and by brute force.
struct Trial {
  oracle::Simplex edge;  ///< of the root
  Refusal refusal;       ///< of the operation itself; not refused: it was done, compared, undone
  bool valid = false;    ///< by identification of vertices, the result is a tree
  std::vector<oracle::SignaturePart> changed;  ///< if valid, what is not what it was
  std::string reason;                          ///< what is invalid, or what changed
  std::string fault;                           ///< a bug: the real result differs, an undo is not exact, ...

  bool accepted() const { return !refusal.refused(); }
  bool unchanged() const { return valid && changed.empty(); }
};

/// Tries the collapse of every edge of a tree, requested on a random copy of the edge in a random mesh. An
/// accepted collapse is done within a transaction, compared with identification, and undone. So the actual
/// effect of the operation is tested, including the link conditions of copies after the first.
class CollapseTrials {
 public:
  /// \pre tree_error(plain) is empty, and all its meshes are orientable
  CollapseTrials(const oracle::Tree& plain, std::uint64_t seed, LegalityOptions legality,
                 oracle::SignatureOptions signature);

  /// Calls back once per edge of the root.
  void run(const std::function<void(const Trial&)>& report);

  /// The tree with the vertex names of the trials.
  const oracle::Tree& plain() const { return plain_; }
  /// "seed 5 edge {1 2}: ..." for messages.
  std::string describe(const Trial& trial) const;

 private:
  Trial attempt(Dart root_edge);
  std::string compare(const oracle::CollapseResult& expected) const;
  std::string misplaced(const oracle::Tree& after, const oracle::CollapseResult& expected) const;

  std::uint64_t seed_;
  std::mt19937_64 rng_;
  MultiMesh tree_;
  Propagation ops_;
  Records records_;
  oracle::Tree plain_;
  oracle::SignatureOptions options_;
  oracle::TreeSignature before_;
};

/// How the trials of one kind of tree went.
struct TrialCount {
  std::size_t candidates = 0;
  std::size_t accepted = 0, invalid = 0, changed = 0;  ///< of the accepted ones: by Trial
  std::size_t refused = 0, harmless = 0;               ///< of the refused ones: would have changed nothing
  std::array<std::size_t, 8> harmless_by{};            ///< by Check

  void add(const Trial& trial);
  std::size_t harmless_refused_by(Check c) const { return harmless_by[static_cast<std::size_t>(c)]; }
  static std::string header();
  std::string row(const std::string& name) const;  ///< in the columns of header()
};

/// MULTIMESH_ORACLE_CANDIDATES, how many candidates a test program tries in total; or the given number.
std::size_t total_candidates(std::size_t fallback);

/// A surface that OpenMesh can hold, all of them in turn.
oracle::Surface orientable_surface(std::uint64_t seed);

/// The same tree with its curves below the root cut where their type changes as well (guards,
/// docs/concepts.md#when-a-collapse-is-legal): where another child or the boundary of the root is met or
/// left. \pre all children are curves below the root
oracle::Tree cut_at_contacts(const oracle::Tree& tree);

}  // namespace multimesh::test
