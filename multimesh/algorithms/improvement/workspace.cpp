// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/workspace.hpp"

#include <algorithm>
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

constexpr std::array<bool, 24> even = [] {
  std::array<bool, 24> table{};
  for (std::uint8_t c = 0; c < 24; ++c) table[c] = is_even({c});
  return table;
}();

// Even permutations that put corner i first.
constexpr std::size_t from_corner[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};

}  // namespace

Workspace::Workspace(TetDomain& domain, const ImproveOptions& options)
    : domain_(domain),
      mesh_(domain.mesh()),
      points_(domain.points().values),
      held_(domain, options),
      flatness_{options.surface_splits == SurfaceSplits::rounded},
      positions_(NodeId::root, points_,
                 [this](Operation operation, const VertexChange& c) -> Vec3 {
                   if (operation == Operation::split) return new_point_;
                   return points_[operation == Operation::collapse && c.t <= 0 ? c.a : c.b];
                 }),
      joined_(domain),
      operations_(domain.tree()) {
  operations_.add(positions_);
  operations_.add(joined_);
  for (Attribute* a : options.carried) operations_.add(*a);
}

std::size_t Workspace::count_tets() const {
  std::size_t n = 0;
  for (Index t = 0; t < mesh_.capacity(3); ++t) n += is_live(t);
  return n;
}

Corners Workspace::corners(Index t, std::size_t first) const {
  const Index* v = mesh_.corners(t);
  const auto& p = from_corner[first];
  return {v[p[0]], v[p[1]], v[p[2]], v[p[3]]};
}

Dart Workspace::edge(Index t, int i, int j) {
  const int k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2;
  return tet::TetMesh::dart(t, permutation(i, j, k, 6 - i - j - k));
}

void Workspace::read_ring(Dart e, Ring& ring) const {
  if (!even[code(e) & 31U]) e = mesh_.reorder(e, transposition(2));
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

void Workspace::read_held_faces(const Ring& ring, std::vector<std::size_t>& faces) const {
  faces.clear();
  if (!(held_.strata(ring.a) & held_.strata(ring.b) & Held::on_face)) return;
  for (std::size_t i = 0; i < ring.rim.size(); ++i)
    if (held_.face(face_at(ring, i))) faces.push_back(i);
}

void Workspace::read_star(Dart v, std::vector<Corners>& star) const {
  mesh_.star(v, 0, darts_);
  star.clear();
  for (const Dart d : darts_)
    star.push_back(corners(tet::TetMesh::tet(d), static_cast<std::size_t>(Permutation{
                                                     static_cast<std::uint8_t>(code(d) & 31U)}[0])));
}

void Workspace::read_star(Dart v, std::vector<Index>& tets) const {
  mesh_.star(v, 0, darts_);
  tets.clear();
  for (const Dart d : darts_) tets.push_back(tet::TetMesh::tet(d));
}

Dart Workspace::keep(const Outcome& outcome) {
  refusal_ = outcome.refusal;
  return outcome.dart;
}

Dart Workspace::split(Dart e, const Vec3& at, std::uint8_t strata) {
  new_point_ = at;
  const Outcome outcome = operations_.split(NodeId::root, e);
  if (outcome) held_.set(mesh_.vertex(mesh_.reorder(outcome.dart, exchange_ends)), strata);
  return keep(outcome);
}

Dart Workspace::collapse(Dart e) {
  return keep(operations_.collapse(NodeId::root, e, Placement::keep_b()));
}

// A swap has its own new vertex, which is gone at once; its place does not matter.
Dart Workspace::swap(Dart e) {
  return keep(operations_.swap(NodeId::root, e));
}

Dart Workspace::swap_in_boundary(Dart e) {
  Transaction both = operations_.transaction();
  const Outcome halves = operations_.split(NodeId::root, e);
  if (!halves) return keep(halves);
  const Dart to_apex = mesh_.reorder(halves.dart, edge_bx);  // (a,c,x,..) -> (c,x,a,..)
  const Outcome done = operations_.collapse(NodeId::root, to_apex, Placement::keep_b());
  if (done) both.commit();
  return keep(done);
}

Dart Workspace::swap_face(Dart f) {
  return keep(operations_.swap_face(NodeId::root, f));
}

bool Workspace::move(Dart v, const Vec3& to) {
  return keep(operations_.relocate(NodeId::root, v,
                                   [&](const Event&) { positions_.set(mesh_.vertex(v), to); })) != no_dart;
}

}  // namespace multimesh::improvement
