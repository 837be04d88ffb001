// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multimesh/geometry/orient3d.hpp"

namespace multimesh::improvement {

namespace {

/// In an order that depends on the points only. \pre positive orientation
std::array<const Vec3*, 4> sorted(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  std::array<const Vec3*, 4> p{&a, &b, &c, &d};
  const auto is_before = [](const Vec3& x, const Vec3& y) {
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
  };
  bool odd = false;
  for (std::size_t end = 3; end > 0; --end)
    for (std::size_t i = 0; i < end; ++i)
      if (is_before(*p[i + 1], *p[i])) std::swap(p[i], p[i + 1]), odd = !odd;
  if (odd) std::swap(p[2], p[3]);
  return p;
}

}  // namespace

// Where the determinant is little more than rounding, another order of the corners would give another one:
// the tetrahedron would be better or worse than itself, and swaps of such could go round and round.
double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double q = cubed_amips(a, b, c, d);
  if (q < certainly_positive) return q;
  if (orient3d(a.data(), b.data(), c.data(), d.data()) <= 0) return std::numeric_limits<double>::infinity();
  const auto p = sorted(a, b, c, d);
  return std::clamp(cubed_amips(*p[0], *p[1], *p[2], *p[3]), certainly_positive, flat);
}

double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double limit) {
  const double q = cubed_amips(a, b, c, d);
  if (q < certainly_positive) return q;
  return limit <= certainly_positive ? std::numeric_limits<double>::infinity() : quality(a, b, c, d);
}

namespace {

// Even permutations that put corner i first.
constexpr std::size_t from_corner[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};

const Embedding& with_tetrahedra(const Embedding& embedding, NodeId node) {
  if (embedding.tree().mesh(node).dimension() == 3) return embedding;
  throw UsageError("improve: the mesh must have dimension 3");
}

}  // namespace

// All tetrahedra are judged here, exactly, before they are made.
Workspace::Workspace(const Embedding& embedding, NodeId node, const ImproveOptions& options)
    : tets_(with_tetrahedra(embedding, node), node, true),
      node_(node),
      mesh_(tets_.mesh()),
      operations_(tets_.operations()),
      points_(tets_.positions(), mesh_, operations_),
      strata_(embedding, node),
      flatness_{options.surface_splits == SurfaceSplits::rounded},
      has_copies_(node != NodeId::root) {
  for (Attribute* a : options.carried) operations_.add(*a);
  for (const Confinement& c : options.confined) confine(c);
  if (!envelopes_.empty() && std::isfinite(options.keep_volume)) keep_volumes(embedding, options.keep_volume);
  strata_.tabulate();
}

void Workspace::confine(const Confinement& c) {
  if (c.how == Confined::fixed) strata_.fix(c.mesh);
  if (c.how != Confined::envelope) return;
  if (tets_.tree().mesh(c.mesh).dimension() != 2)
    throw UsageError("improve: only surfaces can be held in an envelope");
  envelopes_.push_back(
      std::make_unique<StaysInEnvelope>(tets_.tree(), c.mesh, tets_.positions(), c.distance));
  operations_.add(envelopes_.back()->journal());
  operations_.add(*envelopes_.back());
}

void Workspace::keep_volumes(const Embedding& embedding, double share) {
  KeepsVolumes::Part part = [](Index) { return 0; };
  for (const auto& [n, parts] : embedding.kept().parts)
    if (n == node_) part = [list = parts](Index t) { return (*list)[t]; };
  std::vector<NodeId> surfaces;
  for (const auto& e : envelopes_) surfaces.push_back(e->node());
  volumes_.emplace(tets_.tree(), tets_.positions(), std::move(part), std::move(surfaces), share);
  operations_.add(volumes_->journal());
  operations_.add(*volumes_);
}

std::vector<EnvelopeUse> Workspace::measure_envelopes() const {
  std::vector<EnvelopeUse> list;
  for (const auto& e : envelopes_) list.push_back({e->node(), e->envelope().distance(), e->measure()});
  return list;
}

// Where several meshes have the wall, all of them must be.
const StaysInEnvelope* Workspace::envelope_of(Dart wall) const {
  if (envelopes_.empty() || strata_.wall_stays(wall)) return nullptr;
  strata_.meshes_of_wall(wall, meshes_);
  const StaysInEnvelope* found = nullptr;
  for (const NodeId n : meshes_) {
    const auto is_of_n = [n](const auto& e) { return e->node() == n; };
    const auto e = std::ranges::find_if(envelopes_, is_of_n);
    if (e == envelopes_.end()) return nullptr;
    found = e->get();
  }
  return found;
}

std::size_t Workspace::count_tets() const {
  std::size_t n = 0;
  for (Index t = 0; t < mesh_.capacity(3); ++t) n += is_live(t);
  return n;
}

Dart Workspace::edge(Index t, int i, int j) const {
  const int k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2;
  return dart(t, permutation(i, j, k, 6 - i - j - k));
}

void Workspace::read_ring(Dart e, Ring& ring) const {
  if (!is_even(mesh_.order(mesh_.dart_of(3, tet(e)), e))) e = mesh_.reorder(e, transposition(2));
  mesh_.star(e, 1, ring.darts);
  ring.rim.clear();
  Index v[4] = {};
  for (const Dart d : ring.darts) {
    mesh_.vertices(d, v);
    ring.rim.push_back(v[2]);
  }
  ring.a = v[0];
  ring.b = v[1];
  ring.closed = ring.size() > 2 && v[3] == ring.rim.front();
  if (!ring.closed) ring.rim.push_back(v[3]);
}

void Workspace::read_walls(const Ring& ring, std::vector<std::size_t>& faces) const {
  faces.clear();
  if (!(strata_.of(ring.a) & strata_.of(ring.b) & Strata::on_face)) return;
  for (std::size_t i = 0; i < ring.rim.size(); ++i)
    if (strata_.is_wall(face_at(ring, i))) faces.push_back(i);
}

void Workspace::read_star(Dart v, std::vector<Corners>& star) const {
  star.clear();
  read_copies(v, 0, centres_);
  for (const Dart copy : centres_) {
    mesh_.star(copy, 0, darts_);
    const Index centre = mesh_.vertex(copy);
    for (const Dart d : darts_) {
      const Corners c = corners(tet(d));
      const auto& p = from_corner[c[0] == centre ? 0 : c[1] == centre ? 1 : c[2] == centre ? 2 : 3];
      star.push_back({c[p[0]], c[p[1]], c[p[2]], c[p[3]]});
    }
  }
}

void Workspace::read_star(Dart v, std::vector<Index>& tets) const {
  tets.clear();
  read_copies(v, 0, centres_);
  for (const Dart copy : centres_) {
    mesh_.star(copy, 0, darts_);
    for (const Dart d : darts_) tets.push_back(tet(d));
  }
}

// --- copies

void Workspace::add_other_copies(Dart d, int k, DartBuffer& copies) const {
  const Index v = mesh_.vertex(d);
  if (!is_copied(v) || (k > 0 && !is_copied(mesh_.vertex(mesh_.reorder(d, exchange_ends))))) return;
  copies_.collect(tets_.tree(), node_, d, k);
  for (const Copy& c : copies_.of(node_))
    if (mesh_.vertex(c.dart) != v) copies.push_back(c.dart);
}

void Workspace::add_copies(Index v, std::vector<Index>& copies) const {
  if (!is_copied(v)) return copies.push_back(v);
  copies_.collect(tets_.tree(), node_, mesh_.dart_of(0, v), 0);
  for (const Copy& c : copies_.of(node_)) copies.push_back(mesh_.vertex(c.dart));
}

Index Workspace::name_of_copies(Index v) const {
  copies_.collect(tets_.tree(), node_, mesh_.dart_of(0, v), 0);
  for (const Copy& c : copies_.of(node_)) v = std::min(v, mesh_.vertex(c.dart));
  return v;
}

// --- operations

Dart Workspace::split(Dart e, const Vec3& at, std::uint8_t strata) {
  read_copies(e, 1, centres_);
  const bool copied = centres_.size() > 1;
  Transaction both = operations_.transaction();
  const Outcome outcome = operations_.split(node_, e);
  if (!outcome) return no_dart;
  const Dart c = mesh_.reorder(outcome.dart, exchange_ends);
  if (copied) strata |= Strata::copied;
  strata_.set(mesh_.vertex(c), strata);
  read_copies(c, 0, centres_);
  for (const Dart d : centres_) strata_.set(mesh_.vertex(d), strata);
  if (at != point(mesh_.vertex(c)) ? !move(c, at) : copied && !is_positive_around(c)) return no_dart;
  both.commit();
  return outcome.dart;
}

// Copies of the merged vertex are put where they are copies to the last bit, which is not where they were
// judged.
Dart Workspace::collapse(Dart e) {
  const bool copied = is_edge_copied(e);
  Transaction scope = operations_.transaction();
  const Dart merged = operations_.collapse(node_, e, Placement::keep_b()).dart;
  if (merged == no_dart || (copied && !is_positive_around(merged))) return no_dart;
  scope.commit();
  return merged;
}

Dart Workspace::swap(Dart e) {
  return operations_.swap(node_, e).dart;
}

// Asked for in the mesh that has the faces at it.
Dart Workspace::swap_in_boundary(Dart e) {
  for (const NodeId surface :
       mesh_.is_boundary(e, 2) ? tets_.tree().children(node_) : std::span<const NodeId>()) {
    found_.clear();
    if (tets_.tree().mesh(surface).dimension() != 2) continue;
    tets_.tree().to_child(surface, e, 2, found_);
    if (found_.empty()) continue;
    const Outcome done = operations_.swap(surface, found_.front());
    return done ? tets_.tree().to_parent(surface, done.dart) : no_dart;
  }
  return no_dart;
}

Dart Workspace::swap_face(Dart f) {
  return operations_.swap_face(node_, f).dart;
}

// Coordinates may be stored with fewer digits than were judged, and copies at rounded places.
bool Workspace::move(Dart v, const Vec3& to) {
  Transaction scope = operations_.transaction();
  const auto write = [&](const Event&) { tets_.positions().set(mesh_.vertex(v), to); };
  if (!operations_.relocate(node_, v, write)) return false;
  const Index moved = mesh_.vertex(v);
  if ((point(moved) != to || is_copied(moved)) && !is_positive_around(v)) return false;
  scope.commit();
  return true;
}

bool Workspace::is_positive_around(Dart v) {
  read_star(v, star_);
  return std::ranges::all_of(
      star_, [&](const Corners& c) { return quality_of(c) < std::numeric_limits<double>::infinity(); });
}

}  // namespace multimesh::improvement
