// SPDX-License-Identifier: BSD-3-Clause
// The passes: which edges, in which order, and when.
#include "multimesh/algorithms/remeshing/remesher.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace multimesh::remeshing {

namespace {

/// How far the surface may be from the input, and the spacing of the points by which that is judged; relative
/// to the requested length.
constexpr double nearness = 0.37, spacing = 0.5;
/// A pass is repeated until it finds nothing more to do, at most this often.
constexpr int most_sweeps = 16;
/// Vertices whose move is shorter than this, relative to the requested length, stay.
constexpr double smallest_share = 0.004;
/// Per index: of edges of the same length, as in a grid, the newer ones are split first. In grids, more edges
/// come into range; why is not understood.
constexpr double newer_first = 1e-13;
/// Moves of all vertices per round.
constexpr int smoothings = 2;

}  // namespace

Remesher::Remesher(EmbeddedMesh& surface, const RemeshOptions& options)
    : surface_(surface),
      operations_(surface.operations()),
      tree_(surface.tree()),
      node_(surface.node()),
      mesh_(surface.mesh()),
      positions_(surface.positions()),
      below_(surface.charts()),
      options_(options),
      patch_(mesh_.capacity(2), no_index),
      line_(mesh_.capacity(1), 0),
      patch_column_(node_, 2, patch_),
      line_column_(node_, 1, line_, ColumnRules<Index>::larger()),
      shortest_(of_average * shortest_share * options.length),
      longest_(of_average * longest_share * options.length),
      smallest_move_(smallest_share * options.length),
      refused_(4 * std::size_t{mesh_.capacity(2)}),
      splitting_(operations_, node_, stars_),
      collapsing_(operations_, node_, stars_),
      strata_(tree_, node_),
      reference_(surface, strata_, patch_, line_),
      guard_(mesh_, positions_, reference_, nearness * options.length, spacing * options.length),
      shape_(mesh_, positions_),
      sizes_(surface) {
  operations_.add(patch_column_).add(line_column_);
  strata_.trust(line_);
  lock_lines();
  all_has_changed();
  for (const Coordinates* c : below_) {
    sides_below_.push_back(std::make_unique<KeepsOrientation>(*c, tree_.mesh(c->node())));
    operations_.add(*sides_below_.back());
  }
}

void Remesher::lock_lines() {
  if (!options_.lock_boundary && !options_.lock_seams) return;
  locked_lines_.assign(std::size_t{*std::ranges::max_element(line_)} + 1, false);
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e) || line_[e] == 0) continue;
    const Dart d = mesh_.dart_of(1, e);
    if (options_.lock_boundary && mesh_.is_boundary(d, 1)) locked_lines_[line_[e]] = true;
    if (options_.lock_seams && is_side_of_chart(d)) locked_lines_[line_[e]] = true;
  }
}

// Whether a chart is cut open along the edge, or ends there inside the surface.
bool Remesher::is_side_of_chart(Dart edge) {
  if (mesh_.is_boundary(edge, 1)) return false;
  copies_.collect(tree_, node_, edge, 1);
  return std::ranges::any_of(below_, [&](const Coordinates* chart) {
    const std::span<const Copy> here = copies_.of(chart->node());
    return here.size() > 1 || (here.size() == 1 && tree_.mesh(chart->node()).is_boundary(here[0].dart, 1));
  });
}

Freedom Remesher::freedom(Dart vertex, std::array<Dart, 2>& line) const {
  const Freedom free = strata_.freedom(vertex, line);
  return free == Freedom::line && is_locked_line(line[0]) ? Freedom::none : free;
}

RemeshResult Remesher::run() {
  const auto start = std::chrono::steady_clock::now();
  for (int round = 1; round <= options_.iterations; ++round) {
    if (round == 1) collapse_short_edges();
    refine();
    swap_edges();
    for (int i = 0; i < smoothings; ++i) smooth();
    if (options_.progress) options_.progress(round);
    if (options_.between_rounds && round < options_.iterations) let_others_work(round);
  }
  raise_least_angles();
  restore_sizes();
  count_edges();
  result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result_;
}

void Remesher::let_others_work(int round) {
  std::vector<Attribute*> carried = surface_.inherited();
  carried.insert(carried.end(), {&patch_column_, &line_column_});
  options_.between_rounds(round, carried);
  guard_.sort_anew();
  all_has_changed();
}

void Remesher::all_has_changed() {
  corners_.resize(mesh_.capacity(0));
  std::iota(corners_.begin(), corners_.end(), Index{0});
  stars_.change(corners_);
}

void Remesher::note_changes(const DartBuffer& triangles) {
  corners_.clear();
  std::array<Index, 4> v{};
  for (const Dart t : triangles) {
    mesh_.vertices(t, v.data());
    corners_.insert(corners_.end(), v.begin(), v.begin() + 3);
  }
  stars_.change(corners_);
}

// Edges are halved, and edges that are then too short are collapsed, before the halves are halved: many long
// edges side by side become fewer long before they reach the requested length.
void Remesher::refine() {
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const std::size_t done = result_.splits + result_.collapses;
    const PriorityScheduler::Stop stop = split_long_edges();
    collapse_short_edges();
    if (stop == PriorityScheduler::Stop::exhausted && done == result_.splits + result_.collapses) return;
  }
}

// Down to half of the longest one.
PriorityScheduler::Stop Remesher::split_long_edges() {
  struct LongestFirst {
    Remesher& of;
    double halves = 0;
    std::optional<double> cost(Dart e) const {
      const double m = of.measure(e);
      return m > of.longest_ ? std::optional(-m * (1 + newer_first * of.mesh_.simplex(e, 1))) : std::nullopt;
    }
    Outcome apply(Dart e, double) const { return of.halve(e); }
    bool finished(double next) {
      if (halves == 0) halves = next / 2;
      return next >= halves;
    }
  } policy{*this};
  return splitting_.resume(policy);
}

// A triangle whose longest edge is never split gets flatter with each split of another edge, without end.
bool Remesher::flattens_beside_whole(Dart edge) {
  mesh_.star(edge, 1, star_);
  const Vec3 middle = (at(edge) + at(mesh_.reorder(edge, exchange_ends))) / 2;
  return std::ranges::any_of(star_, [&](Dart t) {
    const std::array others{mesh_.reorder(t, edge_ax), mesh_.reorder(t, edge_bx)};
    return std::ranges::any_of(others, [&](Dart side) {
      return splitting_.was_refused(mesh_.simplex(side, 1)) && measure(side) >= measure(edge) &&
             is_flat(at(side), at(mesh_.reorder(side, exchange_ends)), middle);
    });
  });
}

Outcome Remesher::halve(Dart edge) {
  if (!(measure(edge) > longest_) || is_frozen(edge) || flattens_beside_whole(edge)) return refuse();
  const double half = length(edge) / 2;  // the ends are on the input
  copies_.collect(tree_, node_, edge, 1);
  read_stars(copies_, 1, changing_);
  guard_.take(changing_);
  const Outcome o = operations_.split(node_, edge);
  if (!o) {
    guard_.give_back();
    return o;
  }
  ++result_.splits;
  const Dart v = mesh_.reorder(o.dart, exchange_ends);
  copies_.collect(tree_, node_, v, 0);
  read_stars(copies_, 0, changing_);
  guard_.hand_on(changing_);
  std::array<Dart, 2> line{};
  const Freedom free = freedom(v, line);
  Vec3 normal;
  (void)centre(v, normal);
  if (const auto to = place(v, free, line, {at(v), half}, normal)) move(v, *to);
  return o;
}

void Remesher::collapse_short_edges() {
  struct ShortestFirst {
    Remesher& of;
    std::optional<double> cost(Dart e) const {
      const double m = of.measure(e);
      return m < of.shortest_ ? std::optional(m) : std::nullopt;
    }
    Outcome apply(Dart e, double) const { return of.collapse(e); }
    static bool finished(double) { return false; }
  } policy{*this};
  (void)collapsing_.resume(policy);
}

// For (a, b, ..): whether a is free on the surface, or on a curve that contains the edge.
bool Remesher::may_be_removed(Dart edge) {
  std::array<Dart, 2> line{};
  const Freedom free = freedom(edge, line);
  return free == Freedom::surface || (free == Freedom::line && !strata_.is_plain(edge));
}

void Remesher::read_stars(const Copies& copies, int k, DartBuffer& triangles) {
  triangles.clear();
  const std::span<const Copy> here = copies.of(node_);
  for (const Copy& c : here) {
    mesh_.star(c.dart, k, star_);
    triangles.insert(triangles.end(), star_.begin(), star_.end());
  }
  drop_repeated(triangles, here.size());
}

void Remesher::read_stars_of_ends(const Copies& edges, DartBuffer& triangles) {
  triangles.clear();
  const std::span<const Copy> here = edges.of(node_);
  for (const Copy& c : here) {
    const Index a = mesh_.vertex(c.dart);
    mesh_.star(c.dart, 0, star_);
    triangles.insert(triangles.end(), star_.begin(), star_.end());
    mesh_.star(mesh_.reorder(c.dart, exchange_ends), 0, star_);
    for (const Dart t : star_) {
      std::array<Index, 4> v{};
      mesh_.vertices(t, v.data());
      if (v[1] != a && v[2] != a) triangles.push_back(t);
    }
  }
  drop_repeated(triangles, here.size());
}

// Stars of several copies may have common triangles.
void Remesher::drop_repeated(DartBuffer& triangles, std::size_t stars) const {
  if (stars < 2) return;
  std::sort(triangles.begin(), triangles.end(),
            [&](Dart s, Dart t) { return mesh_.facet(s) < mesh_.facet(t); });
  const auto repeated = std::unique(triangles.begin(), triangles.end(),
                                    [&](Dart s, Dart t) { return mesh_.facet(s) == mesh_.facet(t); });
  triangles.erase(repeated, triangles.end());
}

Outcome Remesher::guarded(const std::function<Outcome()>& operation) {
  guard_.take(changing_);
  {
    Transaction undone = operations_.transaction();
    if (const Outcome o = operation()) {
      read_stars(operations_.copies(), o.changed_dimension, changing_);
      if (guard_.settle(changing_)) {
        undone.commit();
        note_changes(changing_);
        return o;
      }
    }
  }
  guard_.give_back();
  return refuse();
}

Outcome Remesher::collapse(Dart edge) {
  if (measure(edge) >= shortest_ || is_frozen(edge)) return refuse();
  std::array<std::pair<double, Dart>, 2> ways{};
  std::size_t n = 0;
  for (const Dart d : {edge, mesh_.reorder(edge, exchange_ends)})
    if (may_be_removed(d)) ways[n++] = {longest_after_collapse(d), d};
  if (n == 2 && ways[1].first < ways[0].first) std::swap(ways[0], ways[1]);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [longest, d] = ways[i];
    if (longest > longest_) continue;
    if (const Outcome o = collapse_guarded(d)) return o;
  }
  return refuse();
}

// For (a, b, ..): moves a to b.
Outcome Remesher::collapse_guarded(Dart d) {
  const Dart b = mesh_.reorder(d, exchange_ends);
  if (!shape_.allows(d, at(b), mesh_.vertex(b))) return refuse();
  copies_.collect(tree_, node_, d, 1);
  if (!others_allow_collapse(d)) return refuse();
  read_stars_of_ends(copies_, changing_);
  const Outcome o = guarded([&] { return operations_.collapse(node_, d, Placement::keep_b()); });
  result_.collapses += static_cast<bool>(o);
  return o;
}

// Whether the other copies of the edge in the surface allow it.
bool Remesher::others_allow_collapse(Dart edge) {
  for (const Copy& c : copies_.of(node_)) {
    const Dart b = mesh_.reorder(c.dart, exchange_ends);
    if (!mesh_.same_simplex(c.dart, edge, 1) && !shape_.allows(c.dart, at(b), mesh_.vertex(b))) return false;
  }
  return true;
}

void Remesher::swap_edges() {
  for (Index e = 0; e < mesh_.capacity(1); ++e)
    if (mesh_.is_live(1, e)) result_.swaps += swap(mesh_.dart_of(1, e));
}

/// How far a vertex is from the regular number of neighbours if it gets `change` more.
int Remesher::deviation(Dart vertex, int change) {
  mesh_.star(vertex, 0, star_);
  const bool boundary = mesh_.is_boundary(vertex, 0);
  const int valence = static_cast<int>(star_.size()) + boundary;
  return std::abs(valence + change - (boundary ? 4 : 6));
}

bool Remesher::may_be_swapped(Dart edge) {
  return !mesh_.is_boundary(edge, 1) && strata_.is_plain(edge);
}

bool Remesher::swap(Dart edge) {
  if (!may_be_swapped(edge)) return false;
  const Dart beyond = mesh_.switch_dart(edge, 2);
  const Dart b = mesh_.reorder(edge, exchange_ends), l = mesh_.reorder(edge, permutation(2, 0, 1)),
             r = mesh_.reorder(beyond, permutation(2, 0, 1));
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
  mesh_.star(edge, 1, changing_);
  return static_cast<bool>(guarded([&] { return operations_.swap(node_, edge); }));
}

}  // namespace multimesh::remeshing
