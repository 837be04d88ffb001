// SPDX-License-Identifier: BSD-3-Clause
#include "property/collapse_trials.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "multimesh/transaction.hpp"
#include "multimesh/validate.hpp"
#include "oracle/image.hpp"
#include "oracle/submesh.hpp"

namespace multimesh::test {

namespace {

MultiMesh real(const oracle::Tree& plain, std::mt19937_64& rng) {
  auto tree = to_multimesh(plain, rng);
  if (!tree) throw std::logic_error("a mesh is not orientable");
  return *std::move(tree);
}

/// Facets in their order, corners in theirs.
bool identical(const oracle::Tree& s, const oracle::Tree& t) {
  for (std::size_t i = 0; i < s.nodes.size(); ++i)
    if (s.nodes[i].mesh.facets != t.nodes[i].mesh.facets || s.nodes[i].image != t.nodes[i].image)
      return false;
  return true;
}

}  // namespace

CollapseTrials::CollapseTrials(const oracle::Tree& plain, std::uint64_t seed, LegalityOptions legality,
                               oracle::SignatureOptions signature)
    : seed_(seed),
      rng_(seed),
      tree_(real(plain, rng_)),
      ops_(tree_),
      records_(ops_, tree_),
      plain_(to_oracle(tree_)),
      options_(signature),
      before_(image_signature(plain_, options_)) {
  ops_.set(legality);
}

void CollapseTrials::run(const std::function<void(const Trial&)>& report) {
  const Mesh& root = tree_.mesh(NodeId::root);
  for (Index e = 0; e < root.capacity(1); ++e) {
    if (!root.is_live(1, e)) continue;
    Trial trial = attempt(root.dart_of(1, e));
    if (trial.fault.empty() && !identical(to_oracle(tree_), plain_)) trial.fault = "not undone exactly";
    report(trial);
  }
}

Trial CollapseTrials::attempt(Dart root_edge) {
  const Mesh& root = tree_.mesh(NodeId::root);
  const int a = static_cast<int>(root.vertex(root_edge));
  const int b = static_cast<int>(root.vertex(root.reorder(root_edge, exchange_ends)));
  Trial trial;
  trial.edge = oracle::simplex({a, b});
  const oracle::CollapseResult expected = oracle::collapse(plain_, a, b);
  trial.valid = expected.valid;
  trial.reason = expected.reason;
  if (expected.valid) {
    const oracle::TreeSignature after = image_signature(expected.tree, options_);
    trial.reason = difference(before_, after);
    for (std::size_t i = 0; i < after.parts.size(); ++i)
      if (after.parts[i] != before_.parts[i]) trial.changed.push_back(after.parts[i]);
  }

  Copies copies;
  copies.collect(tree_, root_edge, 1);
  const Copy asked = copies[oracle::pick(rng_, copies.size())];
  const Dart d =
      tree_.mesh(asked.node).reorder(asked.dart, oracle::chance(rng_, 50) ? exchange_ends : Permutation{});
  records_.clear();
  Transaction undone(tree_, {});
  const CollapseVerdict verdict = ops_.judge(asked.node, d);
  const Outcome outcome = ops_.collapse(asked.node, d);
  trial.refusal = outcome.refusal;
  if (verdict.refusal.refused() && outcome) trial.fault = "judge() refuses what collapse() does";
  if (outcome && expected.valid && trial.fault.empty()) trial.fault = compare(expected);
  return trial;
}

std::string CollapseTrials::compare(const oracle::CollapseResult& expected) const {
  if (const auto problems = validate(tree_); !problems.empty()) return problems.front();
  const oracle::Tree after = to_oracle(tree_);
  const std::string fault = tree_difference(renamed(expected.tree, records_.names_after(expected)), after);
  return fault.empty() ? misplaced(after, expected) : fault;
}

// (P): the merged vertex keeps the index of the end that keeps its place; so a vertex that was not merged has
// the image that it had.
std::string CollapseTrials::misplaced(const oracle::Tree& after,
                                      const oracle::CollapseResult& expected) const {
  for (std::size_t i = 1; i < after.nodes.size(); ++i) {
    const auto merged = [&](int v) {
      return std::any_of(expected.merged[i].begin(), expected.merged[i].end(),
                         [v](const auto& pair) { return pair.first == v || pair.second == v; });
    };
    for (const auto& [v, image] : after.nodes[i].image)
      if (!merged(v) && plain_.nodes[i].image.at(v) != image)
        return "vertex " + std::to_string(v) + " of mesh " + std::to_string(i) + " was moved with its image";
  }
  return {};
}

std::string CollapseTrials::describe(const Trial& trial) const {
  return "seed " + std::to_string(seed_) + " edge " + to_string(trial.edge) + ": " + trial.reason +
         (trial.refusal.refused() ? "; refused by " + std::string(to_string(trial.refusal.check)) : "") +
         " " + trial.fault;
}

void TrialCount::add(const Trial& trial) {
  ++candidates;
  if (trial.accepted()) {
    ++accepted;
    invalid += !trial.valid;
    changed += !trial.unchanged();
  } else {
    ++refused;
    harmless += trial.unchanged();
    harmless_by[static_cast<std::size_t>(trial.refusal.check)] += trial.unchanged();
  }
}

std::string TrialCount::header() {
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%-36s %10s %9s %8s %8s %9s %9s  by L, U, P, C", "kind of tree",
                "candidates", "accepted", "invalid", "changed", "refused", "harmless");
  return line.data();
}

std::string TrialCount::row(const std::string& name) const {
  std::array<char, 160> line{};
  const double share =
      refused == 0 ? 0 : 100.0 * static_cast<double>(harmless) / static_cast<double>(refused);
  std::snprintf(line.data(), line.size(), "%-36s %10zu %9zu %8zu %8zu %9zu %7.2f %%  %zu %zu %zu %zu",
                name.c_str(), candidates, accepted, invalid, changed, refused, share,
                harmless_refused_by(Check::link_condition), harmless_refused_by(Check::gluing),
                harmless_refused_by(Check::placement), harmless_refused_by(Check::contact));
  return line.data();
}

std::size_t total_candidates(std::size_t fallback) {
  const char* given = std::getenv("MULTIMESH_ORACLE_CANDIDATES");
  return given ? std::strtoull(given, nullptr, 10) : fallback;
}

oracle::Surface orientable_surface(std::uint64_t seed) {
  return static_cast<oracle::Surface>(seed % static_cast<std::uint64_t>(oracle::Surface::kMoebius));
}

oracle::Tree cut_at_contacts(const oracle::Tree& tree) {
  const oracle::Complex& root = tree.nodes[0].mesh;
  std::vector<oracle::SimplexSet> images{boundary(root)};
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) images.push_back(image(tree, static_cast<int>(i), 0));
  const auto strata = [&](const oracle::Simplex& s) {
    std::vector<bool> set;
    for (const oracle::SimplexSet& image : images) set.push_back(contains(image, s));
    return set;
  };
  oracle::Tree result{{tree.nodes[0]}};
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const oracle::SimplexSet edges = of_dimension(images[i], 1);
    std::vector<int> cuts;
    for (const oracle::Simplex& e : edges)
      for (const int v : {e.v[0], e.v[1]})
        if (strata(e) != strata(oracle::simplex({v}))) cuts.push_back(v);
    result.nodes.push_back(curve_child(root, 0, edges, cuts));
  }
  return result;
}

}  // namespace multimesh::test
