// SPDX-License-Identifier: BSD-3-Clause
// The passes: which edges, in which order, and when.
#include "multimesh/algorithms/remeshing/remesher.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace multimesh::remeshing {

using OpenMesh::Vec3d;

namespace {

/// How far the surface may be from the input, and how dense the points are by which that is judged; of the
/// length wanted.
constexpr double nearness = 0.37, spacing = 0.5;
/// A pass is repeated until it finds nothing more to do, at most so often.
constexpr int most_sweeps = 16;
/// Vertices that are to move by less than this, of the length wanted, stay.
constexpr double smallest_share = 0.004;
/// Moves of all vertices per round.
constexpr int smoothings = 2;

}  // namespace

Remesher::Remesher(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
                   const RemeshOptions& options, std::vector<Index>& patch, std::vector<Index>& line,
                   Hooks hooks)
    : operations_(operations),
      tree_(operations.tree()),
      root_(tree_.mesh(NodeId::root)),
      positions_(positions),
      below_(below),
      options_(options),
      patch_(patch),
      line_(line),
      hooks_(std::move(hooks)),
      shortest_(of_average * shortest_share * options.length),
      longest_(of_average * longest_share * options.length),
      smallest_move_(smallest_share * options.length),
      strata_(tree_),
      reference_(tree_, positions, below, strata_, patch, line),
      guard_(root_, positions, reference_, nearness * options.length, spacing * options.length),
      shape_(root_, positions) {
  strata_.trust(line);
  for (const Coordinates* c : below) sides_below_.emplace_back(tree_.mesh(c->node()), *c);
}

RemeshResult Remesher::run() {
  const auto start = std::chrono::steady_clock::now();
  for (int round = 1; round <= options_.iterations; ++round) {
    for (int i = 0; round == 1 && i < most_sweeps; ++i)
      if (!collapse_short_edges()) break;
    refine();
    swap_edges();
    for (int i = 0; i < smoothings; ++i) smooth();
    if (options_.progress) options_.progress(round);
  }
  raise_least_angles();
  count_edges();
  result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result_;
}

// Edges in reach are halved once at a time, and what is too short then is collapsed: many long edges side by
// side become fewer long before they are as short as they shall be.
void Remesher::refine() {
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const std::size_t split = split_long_edges();
    const std::size_t collapsed = collapse_short_edges();
    if (split == 0 && collapsed == 0) return;
  }
}

std::size_t Remesher::split_long_edges() {
  auto list = edges_in(longest_, std::numeric_limits<double>::infinity());
  std::reverse(list.begin(), list.end());
  std::size_t split = 0;
  for (const auto& [was, e] : list) {
    const Dart d = root_.dart_of(1, e);
    if (measure(d) > longest_ && !strata_.is_frozen(d)) split += halve(d);
  }
  result_.splits += split;
  return split;
}

bool Remesher::halve(Dart edge) {
  const double half = length(edge) / 2;  // the ends are on the input
  root_.star(edge, 1, changing_);
  guard_.take(changing_);
  const Dart v = split(edge);
  if (v == no_dart) {
    guard_.give_back();
    return false;
  }
  root_.star(v, 0, changing_);
  guard_.hand_on(changing_);
  std::array<Dart, 2> line{};
  const Freedom freedom = strata_.freedom(v, line);
  Vec3d normal;
  (void)centre(v, normal);
  if (const auto to = place(v, freedom, line, {at(v), half}, normal)) move(v, *to);
  return true;
}

// The middle of a thin triangle's edge may be rounded to its other side. Returns the new vertex.
Dart Remesher::split(Dart edge) {
  const std::vector<PlaneSides::Count> before = count_sides(edge, 1);
  Transaction undone = operations_.transaction();
  const Outcome o = operations_.split(NodeId::root, edge);
  if (!o) return no_dart;
  const Dart v = root_.reorder(o.root, exchange_ends);
  const std::vector<PlaneSides::Count> after = count_sides(v, 0);
  for (std::size_t m = 0; m < below_.size(); ++m)
    if (!PlaneSides::halved(before[m], after[m])) return no_dart;
  undone.commit();
  return v;
}

// Of the triangles around all copies of a simplex in each mesh below.
std::vector<PlaneSides::Count> Remesher::count_sides(Dart d, int k) {
  copies_.collect(tree_, d, k);
  std::vector<PlaneSides::Count> counts(below_.size());
  for (std::size_t m = 0; m < below_.size(); ++m)
    for (const Copy& c : copies_.of(below_[m]->node())) sides_below_[m].count(c.dart, k, counts[m]);
  return counts;
}

std::size_t Remesher::collapse_short_edges() {
  std::size_t collapsed = 0;
  for (const auto& [was, e] : edges_in(-1, shortest_))
    if (root_.is_live(1, e)) collapsed += collapse(root_.dart_of(1, e));
  result_.collapses += collapsed;
  return collapsed;
}

// Of (a, b, ..): a is free on the surface, or on a line that the edge is part of.
bool Remesher::may_be_removed(Dart edge) {
  const Freedom freedom = strata_.freedom(edge);
  return freedom == Freedom::surface || (freedom == Freedom::line && !strata_.is_plain(edge));
}

bool Remesher::guarded(DartBuffer& triangles, int k, const std::function<Outcome()>& operation) {
  guard_.take(triangles);
  {
    Transaction undone = operations_.transaction();
    if (const Outcome o = operation()) {
      root_.star(o.root, k, triangles);
      if (guard_.settle(triangles)) {
        undone.commit();
        return true;
      }
    }
  }
  guard_.give_back();
  return false;
}

// A line through a goes on from b afterwards: by an edge that may have been no part of it.
std::optional<Remesher::Merged> Remesher::merged_line(Dart edge) {
  const Index number = line_[root_.simplex(edge, 1)];
  std::array<Dart, 2> line{};
  if (number == 0 || strata_.freedom(edge, line) != Freedom::line) return std::nullopt;
  const Dart next = root_.same_simplex(line[0], edge, 1) ? line[1] : line[0];
  return Merged{root_.vertex(root_.reorder(edge, exchange_ends)),
                root_.vertex(root_.reorder(next, exchange_ends)), number};
}

void Remesher::number_line(const Merged& line) {
  edges_around(root_, root_.dart_of(0, line.from), edges_);
  for (const Dart e : edges_)
    if (root_.vertex(root_.reorder(e, exchange_ends)) == line.to) line_[root_.simplex(e, 1)] = line.number;
}

bool Remesher::collapse(Dart edge) {
  if (measure(edge) >= shortest_ || strata_.is_frozen(edge)) return false;
  std::array<std::pair<double, Dart>, 2> ways{};
  std::size_t n = 0;
  for (const Dart d : {edge, root_.reorder(edge, exchange_ends)})
    if (may_be_removed(d)) ways[n++] = {longest_after_collapse(d), d};
  if (n == 2 && ways[1].first < ways[0].first) std::swap(ways[0], ways[1]);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [longest, d] = ways[i];
    if (longest <= longest_ && collapse_guarded(d)) return true;
  }
  return false;
}

// Of (a, b, ..): a goes to b.
bool Remesher::collapse_guarded(Dart d) {
  const Dart b = root_.reorder(d, exchange_ends);
  if (!shape_.allows(d, at(b), root_.vertex(b)) || !collapse_keeps_sides_below(d)) return false;
  const std::optional<Merged> line = merged_line(d);
  const auto done = hooks_.collapsing ? hooks_.collapsing(d) : std::function<void()>();
  root_.star(d, 0, changing_);
  root_.star(b, 0, star_);
  for (const Dart t : star_)
    if (root_.vertex(d) != root_.vertex(root_.reorder(t, exchange_ends)) &&
        root_.vertex(d) != root_.vertex(root_.reorder(t, permutation(2, 0, 1))))
      changing_.push_back(t);
  if (!guarded(changing_, 0, [&] { return operations_.collapse(NodeId::root, d, Placement::keep_b()); }))
    return false;
  if (line) number_line(*line);
  if (done) done();
  return true;
}

bool Remesher::collapse_keeps_sides_below(Dart edge) {
  copies_.collect(tree_, edge, 1);
  for (std::size_t m = 0; m < below_.size(); ++m)
    for (const Copy& c : copies_.of(below_[m]->node())) {
      const Mesh& mesh = tree_.mesh(c.node);
      const Index kept = mesh.vertex(mesh.reorder(c.dart, exchange_ends));
      if (!sides_below_[m].allows(c.dart, below_[m]->at(kept), kept)) return false;
    }
  return true;
}

void Remesher::swap_edges() {
  for (Index e = 0; e < root_.capacity(1); ++e)
    if (root_.is_live(1, e)) result_.swaps += swap(root_.dart_of(1, e));
}

/// How far from the regular number of neighbours a vertex is with so many more.
int Remesher::deviation(Dart vertex, int change) {
  root_.star(vertex, 0, star_);
  const bool boundary = root_.is_boundary(vertex, 0);
  const int valence = static_cast<int>(star_.size()) + boundary;
  return std::abs(valence + change - (boundary ? 4 : 6));
}

bool Remesher::may_be_swapped(Dart edge) {
  if (root_.is_boundary(edge, 1) || !strata_.is_plain(edge)) return false;
  return !hooks_.keeps_edge || !hooks_.keeps_edge(root_.simplex(edge, 1));
}

bool Remesher::swap(Dart edge) {
  if (!may_be_swapped(edge)) return false;
  const Dart beyond = root_.switch_dart(edge, 2);
  const Dart b = root_.reorder(edge, exchange_ends), l = root_.reorder(edge, permutation(2, 0, 1)),
             r = root_.reorder(beyond, permutation(2, 0, 1));
  const int now = deviation(edge, 0) + deviation(b, 0) + deviation(l, 0) + deviation(r, 0);
  const int then = deviation(edge, -1) + deviation(b, -1) + deviation(l, 1) + deviation(r, 1);
  if (then > now) return false;
  const double angle_now = std::min(least_angle(at(edge), at(b), at(l)), least_angle(at(edge), at(b), at(r)));
  const double angle_then = std::min(least_angle(at(edge), at(r), at(l)), least_angle(at(b), at(r), at(l)));
  if (then == now ? angle_then <= angle_now : angle_then < 0.5 * angle_now) return false;
  return swap_guarded(edge);
}

bool Remesher::swap_guarded(Dart edge) {
  if (!shape_.allows_swap(edge)) return false;
  copies_.collect(tree_, edge, 1);
  for (std::size_t m = 0; m < below_.size(); ++m)
    for (const Copy& c : copies_.of(below_[m]->node()))
      if (!sides_below_[m].allows_swap(c.dart)) return false;
  root_.star(edge, 1, changing_);
  return guarded(changing_, 1, [&] { return operations_.swap(NodeId::root, edge); });
}

}  // namespace multimesh::remeshing
