// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/stays_in_envelope.hpp"

#include <algorithm>

#include "multimesh/geometry/bounding_box.hpp"

namespace multimesh {

namespace {

using spatial::Triangle;
using spatial::Witnesses;

Vec3 middle(const Triangle& t) {
  return (t[0] + t[1] + t[2]) / 3;
}

Triangle shifted(const Triangle& t, const Vec3& by) {
  return {t[0] + by, t[1] + by, t[2] + by};
}

}  // namespace

void StaysInEnvelope::Journal::set(Index input, const Witnesses::Set& set) {
  old_.emplace_back(input, witnesses_.of(input));
  witnesses_.set(input, set);
}

void StaysInEnvelope::Journal::rollback(Mark mark) {
  for (; old_.size() > mark; old_.pop_back()) witnesses_.set(old_.back().first, old_.back().second);
}

StaysInEnvelope::StaysInEnvelope(const MultiMesh& tree, NodeId surface, const Coordinates& places,
                                 double distance)
    : Invariant("surface stays in its envelope", surface),
      tree_(tree),
      mesh_(tree.mesh(surface)),
      places_(places),
      distance_(distance),
      input_(mesh_.capacity(2)),
      witnesses_(mesh_.capacity(2)),
      journal_(surface, witnesses_),
      candidates_(distance) {
  read_input();
}

void StaysInEnvelope::read_input() {
  for (Index f = 0; f < input_.size(); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    input_[f] = triangle(f);
    Witnesses::Set self;
    self.fill(no_index);
    self[0] = f;
    witnesses_.set(f, self);
  }
  envelope_.emplace(with_neighbours(current()), distance_);
}

std::vector<Triangle> StaysInEnvelope::current() const {
  std::vector<Triangle> surface;
  for (Index f = 0; f < mesh_.capacity(2); ++f)
    if (mesh_.is_live(2, f)) surface.push_back(triangle(f));
  return surface;
}

// Copies of the surface in neighbouring tiles count where they may come near this one, however far its sides
// wander.
std::vector<Triangle> StaysInEnvelope::with_neighbours(std::vector<Triangle> surface) const {
  const std::vector<Vec3> periods = places_.periods();
  if (periods.empty() || surface.empty()) return surface;
  Vec3 low = surface[0][0], high = low;
  for (const Triangle& t : surface)
    for (const Vec3& p : t) low = min(low, p), high = max(high, p);
  const Vec3 margin = (high - low) / 2 + Vec3(distance_, distance_, distance_);
  const std::size_t own = surface.size();
  for (const Vec3& period : periods)
    for (std::size_t i = 0; i < own; ++i) {
      const Triangle t = shifted(surface[i], period);
      const Vec3 least = min(min(t[0], t[1]), t[2]), most = max(max(t[0], t[1]), t[2]);
      bool near = true;
      for (std::size_t k = 0; k < 3; ++k)
        near = near && most[k] >= low[k] - margin[k] && least[k] <= high[k] + margin[k];
      if (near) surface.push_back(t);
    }
  return surface;
}

std::array<double, 2> StaysInEnvelope::measure() const {
  const std::vector<Triangle> now = current();
  std::vector<Triangle> before;
  for (Index f = 0; f < input_.size(); ++f)
    if (input_[f] != Triangle{}) before.push_back(input_[f]);
  const auto farthest = [](const std::vector<Triangle>& from, const spatial::Envelope& to) {
    double most = 0;
    for (const Triangle& t : from)
      for (const auto& [u, v] :
           {std::pair{0., 0.}, {1., 0.}, {0., 1.}, {.5, .5}, {.5, 0.}, {0., .5}, {1. / 3, 1. / 3}}) {
        const Vec3 p = spatial::at(t, {1 - u - v, u, v});
        most = std::max(most, (to.closest(p) - p).norm());
      }
    return most;
  };
  if (now.empty() || before.empty()) return {};
  return {farthest(now, *envelope_), farthest(before, {with_neighbours(now), distance_})};
}

// As the mesh with the places has it; in a tile, one of several copies.
Triangle StaysInEnvelope::triangle(Index facet) const {
  images_.clear();
  tree_.map(node(), mesh_.dart_of(2, facet), 2, places_.node(), MultiMesh::Via::root, images_);
  Index v[4];
  tree_.mesh(places_.node()).vertices(images_.front(), v);
  return {places_.at(v[0]), places_.at(v[1]), places_.at(v[2])};
}

void StaysInEnvelope::read_facets(const Event& event, bool after, std::vector<Facet>& facets) {
  facets.clear();
  star_.clear();
  const auto add = [&](Dart d, int k) {
    mesh_.star(d, k, one_star_);
    star_.insert(star_.end(), one_star_.begin(), one_star_.end());
  };
  for (const Copy& c : event.copies.of(node())) {
    const Dart other = event.operation == Operation::relocate ? c.dart : mesh_.reorder(c.dart, exchange_ends);
    switch (event.operation) {
      case Operation::relocate:
        add(c.dart, 0);
        break;
      case Operation::flip:
        add(c.dart, 1);
        break;
      case Operation::split:
        add(after ? other : c.dart, after ? 0 : 1);
        break;
      case Operation::collapse:
        add(c.dart, 0);
        if (!after) add(other, 0);
    }
  }
  for (const Dart d : star_) facets.push_back({mesh_.facet(d), {}, true});
  const auto by_index = [](const Facet& f, const Facet& g) { return f.index < g.index; };
  const auto same = [](const Facet& f, const Facet& g) { return f.index == g.index; };
  std::sort(facets.begin(), facets.end(), by_index);
  facets.erase(std::unique(facets.begin(), facets.end(), same), facets.end());
  for (Facet& f : facets) f.triangle = triangle(f.index);
}

bool StaysInEnvelope::before(const Event& event) {
  read_facets(event, false, before_);
  return true;
}

bool StaysInEnvelope::after(const Event& event) {
  if (before_.empty()) return true;
  read_facets(event, true, after_);
  for (Facet& f : before_)
    for (Facet& g : after_)
      if (f.index == g.index && f.triangle == g.triangle) f.changed = g.changed = false;
  if (event.operation != Operation::split)  // parts of what was inside
    for (const Facet& f : after_)
      if (f.changed && !envelope_->contains(f.triangle)) return false;
  inputs_.clear();
  for (const Facet& f : before_)
    if (f.changed)
      (void)witnesses_.all_of(f.index, [&](Index input) {
        inputs_.push_back(input);
        return true;
      });
  std::sort(inputs_.begin(), inputs_.end());
  inputs_.erase(std::unique(inputs_.begin(), inputs_.end()), inputs_.end());
  found_.clear();
  if (!std::all_of(inputs_.begin(), inputs_.end(), [&](Index input) { return find_witnesses(input); }))
    return false;
  for (const auto& [input, set] : found_) journal_.set(input, set);
  return true;
}

Triangle StaysInEnvelope::seen(const Triangle& t, const Vec3& near) const {
  const Vec3 m = middle(t);
  return shifted(t, places_.image_near(m, near) - m);
}

// Those that changed come first: there is not room for more than a few.
void StaysInEnvelope::add_candidates(Index input, const Vec3& near) {
  const std::size_t room = spatial::NearTriangles::capacity - Witnesses::most;
  candidates_.shrink(0);
  for (const bool changed : {true, false})
    for (const Facet& f : after_)
      if (f.changed == changed && candidates_.size() < room) candidates_.add(f.index, seen(f.triangle, near));
  for (const Index w : witnesses_.of(input)) {
    const auto is_w = [w](const Facet& f) { return f.index == w; };
    if (w == no_index || std::ranges::any_of(before_, is_w) || std::ranges::any_of(after_, is_w)) continue;
    candidates_.add(w, seen(triangle(w), near));
  }
}

bool StaysInEnvelope::find_witnesses(Index input) {
  add_candidates(input, middle(input_[input]));
  const spatial::TriangleCover cover(candidates_);
  spatial::CoveredPart part;
  for (std::size_t i = 0; i < 3; ++i) part[i] = cover.corner(input_[input][i]);
  spatial::NearTriangles::Mask chosen = 0;
  if (!cover.find(part, chosen)) return false;
  found_.emplace_back(input, cover.named(chosen));
  return true;
}

}  // namespace multimesh
