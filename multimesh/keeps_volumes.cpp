// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/keeps_volumes.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/geometry/tet_shape.hpp"

namespace multimesh {

namespace {

double six_volume_of(const Mesh& mesh, const Coordinates& positions, Index t) {
  Index v[4];
  mesh.facet_vertices(t, v);  // in the order of its orientation
  return six_volume(positions.at(v[0]), positions.at(v[1]), positions.at(v[2]), positions.at(v[3]));
}

}  // namespace

void KeepsVolumes::Journal::add(std::int32_t part, double volume) {
  double& change = changes_[part];
  old_.emplace_back(part, change);
  change += volume;
}

double KeepsVolumes::Journal::change(std::int32_t part) const {
  const auto found = changes_.find(part);
  return found == changes_.end() ? 0 : found->second;
}

void KeepsVolumes::Journal::rollback(Mark mark) {
  for (; old_.size() > mark; old_.pop_back()) changes_[old_.back().first] = old_.back().second;
}

KeepsVolumes::KeepsVolumes(const MultiMesh& tree, const Coordinates& positions, Part part,
                           std::vector<NodeId> surfaces, double share)
    : Invariant("volumes are kept", positions.node()),
      mesh_(tree.mesh(positions.node())),
      positions_(positions),
      part_(std::move(part)),
      surfaces_(std::move(surfaces)),
      share_(share),
      journal_(positions.node()) {
  for (Index t = 0; t < mesh_.capacity(3); ++t)
    if (mesh_.is_live(3, t)) all_[part_(t)] += six_volume_of(mesh_, positions_, t);
}

// A split puts its vertex into the edge: the volumes are the same ones.
bool KeepsVolumes::may_change(const Event& event) const {
  return (event.operation == Operation::collapse || event.operation == Operation::relocate) &&
         std::ranges::any_of(surfaces_, [&](NodeId n) { return event.copies.count(n) > 0; });
}

void KeepsVolumes::add_volumes(const Event& event, bool after) {
  tets_.clear();
  const auto add_star = [&](Dart d) {
    mesh_.star(d, 0, star_);
    for (const Dart t : star_) tets_.push_back(mesh_.facet(t));
  };
  for (const Copy& c : event.copies.of(node())) {
    add_star(c.dart);
    if (event.operation == Operation::collapse && !after) add_star(mesh_.reorder(c.dart, exchange_ends));
  }
  std::sort(tets_.begin(), tets_.end());
  tets_.erase(std::unique(tets_.begin(), tets_.end()), tets_.end());
  for (const Index t : tets_) changed_[part_(t)] += (after ? 1 : -1) * six_volume_of(mesh_, positions_, t);
}

bool KeepsVolumes::before(const Event& event) {
  changed_.clear();
  if (may_change(event)) add_volumes(event, false);
  return true;
}

bool KeepsVolumes::after(const Event& event) {
  if (changed_.empty()) return true;
  add_volumes(event, true);
  for (const auto& [part, volume] : changed_) {
    const double old = journal_.change(part), now = old + volume;
    if (std::abs(now) > share_ * all_[part] && std::abs(now) > std::abs(old)) return false;
  }
  for (const auto& [part, volume] : changed_) journal_.add(part, volume);
  return true;
}

}  // namespace multimesh
