// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/strata.hpp"

#include <algorithm>

#include "multimesh/embedding.hpp"
#include "multimesh/faces.hpp"

namespace multimesh {

Strata::Strata(const MultiMesh& tree, NodeId node) : tree_(tree), node_(node), mesh_(tree.mesh(node)) {
  classify_meshes();
}

Strata::Strata(const Embedding& embedding, NodeId node) : Strata(embedding.tree(), node) {
  embedding_ = &embedding;
  kept_ = &embedding.kept();
  for (const NodeId n : tree_.descendants(node_))
    if (embedding.is_chart(n) && tree_.mesh(n).dimension() == mesh_.dimension()) charts_.push_back(n);
}

// A mesh below one of its own dimension has nothing that that one has not.
void Strata::classify_meshes() {
  for (const NodeId n : tree_.nodes()) {
    const int k = tree_.mesh(n).dimension();
    if (n == NodeId::root || n == node_ || k >= mesh_.dimension()) continue;
    if (tree_.parent(n) == node_)
      below_[static_cast<std::size_t>(k)].push_back(n);
    else if (tree_.mesh(tree_.parent(n)).dimension() != k)
      elsewhere_[static_cast<std::size_t>(k)].push_back(n);
  }
}

// --- edges and vertices of a surface

EdgeKind Strata::kind(Dart e) const {
  if (numbers_ && (*numbers_)[mesh_.simplex(e, 1)] == 0) return {};
  copies_.collect(tree_, node_, e, 1);
  EdgeKind kind;
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    if (mesh.dimension() > 2) continue;
    const std::span<const Copy> here = copies_.of(n);
    // A seam may be interior in its mesh: where two sheets have the edge.
    for (const Copy& c : here)
      if (mesh.dimension() == 1 || here.size() > 1 || mesh.is_boundary(c.dart, 1))
        add(kind, c, here.size() > 1);
  }
  return kind;
}

void Strata::add(EdgeKind& kind, const Copy& c, bool several) const {
  kind.meshes_.push_back(index(c.node));
  const Mesh& mesh = tree_.mesh(c.node);
  if (mesh.dimension() == 1) {
    kind.has_shape_ |= !(embedding_ && embedding_->is_only_seam(c.node, mesh.facet(c.dart)));
  } else {
    const bool is_cut_chart = several && std::ranges::find(charts_, c.node) != charts_.end();
    kind.is_seam_ |= is_cut_chart;
    kind.has_shape_ |= !is_cut_chart;
  }
}

// At the root these are the images of what has curves: a look at every edge costs far more.
std::vector<Index> Strata::curves() const {
  std::vector<Index> numbers(mesh_.capacity(1), 0);
  if (node_ != NodeId::root) {
    for (Index e = 0; e < mesh_.capacity(1); ++e)
      if (mesh_.is_live(1, e)) numbers[e] = !is_plain(mesh_.dart_of(1, e));
    return numbers;
  }
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    for (Index e = 0; mesh.dimension() > 0 && e < mesh.capacity(1); ++e) {
      if (!mesh.is_live(1, e)) continue;
      const Dart d = mesh.dart_of(1, e);
      if (mesh.dimension() == 1 || mesh.is_boundary(d, 1)) numbers[mesh_.simplex(tree_.to_root(n, d), 1)] = 1;
    }
  }
  return numbers;
}

// Per vertex: false only if it is free, as a look at its star would show.
std::vector<bool> Strata::may_be_bound() const {
  std::vector<bool> may(mesh_.capacity(0), node_ != NodeId::root);
  if (node_ != NodeId::root) return may;
  const std::vector<Index> found = numbers_ ? std::vector<Index>{} : curves();
  const std::vector<Index>& numbers = numbers_ ? *numbers_ : found;
  for (Index e = 0; e < numbers.size(); ++e) {
    if (numbers[e] == 0) continue;
    const Dart d = mesh_.dart_of(1, e);
    may[mesh_.vertex(d)] = may[mesh_.vertex(mesh_.reorder(d, exchange_ends))] = true;
  }
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && (mesh.dimension() == 0 || mesh.is_locked(v)) && mesh.dart_of(0, v) != no_dart)
        may[mesh_.vertex(tree_.to_root(n, mesh.dart_of(0, v)))] = true;
  }
  return may;
}

std::vector<Freedom> Strata::freedoms() const {
  std::vector<Freedom> all(mesh_.capacity(0), Freedom::surface);
  const std::vector<bool> may = may_be_bound();
  for (Index v = 0; v < all.size(); ++v)
    if (const Dart d = may[v] && mesh_.is_live(0, v) ? mesh_.dart_of(0, v) : no_dart; d != no_dart)
      all[v] = freedom(d);
  return all;
}

void Strata::sheets(Dart e, DartBuffer& out) const {
  out.assign(1, e);
  if (node_ == NodeId::root) return;
  copies_.collect(tree_, node_, e, 1);
  for (const Copy& c : copies_.of(node_))
    if (!mesh_.same_simplex(c.dart, e, 1)) out.push_back(c.dart);
}

Freedom Strata::freedom(Dart vertex, std::array<Dart, 2>& line) const {
  if (is_locked(vertex)) return Freedom::none;
  edges_around(mesh_, vertex, edges_);
  EdgeKind first;
  int n = 0;
  for (const Dart e : edges_) {
    EdgeKind k = kind(e);
    if (k.is_plain()) continue;
    if (n == 2 || (n == 1 && !(k == first))) return Freedom::none;
    line[static_cast<std::size_t>(n++)] = e;
    if (n == 1) first = std::move(k);
  }
  if (n == 1 || !runs_through(vertex, first)) return Freedom::none;
  return n == 0 ? Freedom::surface : Freedom::line;
}

// In every mesh the vertex has as many preimages as each of its two edges; no curve ends there, and it is no
// point that is kept.
bool Strata::runs_through(Dart vertex, const EdgeKind& kind) const {
  copies_.collect(tree_, node_, vertex, 0);
  for (const NodeId n : tree_.nodes()) {
    const auto of_edge =
        static_cast<std::uint32_t>(std::count(kind.meshes_.begin(), kind.meshes_.end(), index(n)));
    const std::span<const Copy> here = copies_.of(n);
    const Mesh& mesh = tree_.mesh(n);
    for (const Copy& c : here)
      if (mesh.dimension() == 0 || mesh.is_locked(mesh.vertex(c.dart))) return false;
    if (mesh.dimension() == 1) {
      if (here.size() != of_edge) return false;
      for (const Copy& c : here)
        if (mesh.is_boundary(c.dart, 0)) return false;
    } else if (mesh.dimension() == 2 && (of_edge > 0 ? here.size() != of_edge : here.size() > 1)) {
      return false;
    }
  }
  return true;
}

// --- of any mesh

bool Strata::is_locked(Dart vertex) const {
  if (mesh_.is_locked(mesh_.vertex(vertex))) return true;
  if (node_ == NodeId::root) return false;
  const Mesh& root = tree_.mesh(NodeId::root);
  return root.is_locked(root.vertex(tree_.to_root(node_, vertex)));
}

// Whether all corners of a k-simplex are in the stratum: only then may it be itself.
bool Strata::may_be(Dart d, int k, Stratum stratum) const {
  if (strata_.empty()) return true;
  Index v[4];
  mesh_.vertices(d, v);
  std::uint8_t common = stratum;
  for (int i = 0; i <= k; ++i) common &= strata_[v[i]];
  return common != 0;
}

// Whether `visit` is true of a facet, in some mesh of dimension k, over the simplex.
template <class Visit>
bool Strata::any_over(Dart d, int k, const Visit& visit) const {
  for (const NodeId n : below_[static_cast<std::size_t>(k)])
    if (const Index f = tree_.facet_over(n, d); f != no_index && visit(n, f)) return true;
  const std::vector<NodeId>& elsewhere = elsewhere_[static_cast<std::size_t>(k)];
  if (elsewhere.empty()) return false;
  copies_.collect(tree_, node_, d, k);
  return std::ranges::any_of(elsewhere, [&](NodeId n) {
    return std::ranges::any_of(copies_.of(n),
                               [&](const Copy& c) { return visit(n, tree_.mesh(n).facet(c.dart)); });
  });
}

bool Strata::parts_differ(Dart f, Dart beyond) const {
  if (kept_)
    for (const auto& [n, part] : kept_->parts)
      if (n == node_ && (*part)[mesh_.facet(f)] != (*part)[mesh_.facet(beyond)]) return true;
  return false;
}

// The face as the facet on its other side has it; that may be at another preimage.
Dart Strata::beyond(Dart f) const {
  const Dart across = mesh_.switch_dart(f, 3);
  if (across != no_dart || node_ == NodeId::root || !may_be(f, 2, copied) || !has_preimages_beside(f, 2))
    return across;
  const auto other = [&](const Copy& c) { return mesh_.facet(c.dart) != mesh_.facet(f); };
  const std::span<const Copy> all = copies_.of(node_);
  const auto found = std::ranges::find_if(all, other);
  return found == all.end() ? no_dart : found->dart;
}

bool Strata::is_wall(Dart f) const {
  if (!may_be(f, 2, on_face)) return false;
  const Dart across = beyond(f);
  return across == no_dart || parts_differ(f, across) || any_over(f, 2, [](NodeId, Index) { return true; });
}

void Strata::meshes_of_wall(Dart f, std::vector<NodeId>& meshes) const {
  meshes.clear();
  (void)any_over(f, 2, [&](NodeId n, Index) {
    meshes.push_back(n);
    return false;
  });
}

bool Strata::is_curve(Dart e) const {
  if (!may_be(e, 1, on_curve)) return false;
  return mesh_.dimension() == 3 ? any_over(e, 1, [](NodeId, Index) { return true; }) : !is_plain(e);
}

// --- what may not change

bool Strata::is_fixed_mesh(NodeId n) const {
  return std::ranges::find(fixed_, n) != fixed_.end();
}

bool Strata::stays(NodeId n, Index facet) const {
  if (n != node_ && is_fixed_mesh(n)) return true;
  return may_facets_stay() &&
         std::ranges::any_of(kept_->facets, [&](const SimplicesStay* s) { return s->stays(n, facet); });
}

bool Strata::facets_stay_at(Dart vertex) const {
  if (!may_facets_stay()) return false;
  copies_.collect(tree_, node_, vertex, 0);
  return std::ranges::any_of(copies_.all(), [&](const Copy& c) {
    const Mesh& mesh = tree_.mesh(c.node);
    mesh.star(c.dart, 0, star_);
    return std::ranges::any_of(star_, [&](Dart f) { return stays(c.node, mesh.facet(f)); });
  });
}

bool Strata::has_preimages_beside(Dart d, int k) const {
  if (node_ == NodeId::root) return false;
  copies_.collect(tree_, node_, d, k);
  return copies_.count(node_) > 1;
}

bool Strata::wall_stays(Dart f) const {
  if (fixed_.empty() && !may_facets_stay()) return false;
  bool has_mesh = false;
  const auto stays_there = [&](NodeId n, Index facet) {
    has_mesh = true;
    return stays(n, facet);
  };
  return any_over(f, 2, stays_there) || (!has_mesh && is_fixed_mesh(node_));
}

bool Strata::is_kept_anywhere(Dart e) const {
  Dart image = e;
  for (NodeId n = node_;; n = tree_.parent(n)) {
    for (const auto& [node, keeps] : kept_->edges)
      if (node == n && keeps(image)) return true;
    if (n == NodeId::root) return false;
    image = tree_.to_parent(n, image);
  }
}

bool Strata::edge_stays(Dart e) const {
  if (!may_be(e, 1, fixed)) return false;
  if (is_kept(e)) return true;
  return any_over(e, 1, [&](NodeId n, Index edge) { return stays(n, edge); });
}

// --- for loops

void Strata::tabulate() {
  std::vector<std::uint8_t> found(mesh_.capacity(0), 0);
  strata_.clear();  // nothing is looked up there while it is made
  const auto mark = [&](Dart vertex, int strata) {
    found[mesh_.vertex(vertex)] |= static_cast<std::uint8_t>(strata);
  };
  for (Index v = 0; v < mesh_.capacity(0); ++v) {
    if (!mesh_.is_live(0, v)) continue;
    const Dart d = mesh_.dart_of(0, v);
    if (d == no_dart) continue;
    if (is_locked(d)) mark(d, fixed);
    if (has_preimages_beside(d, 0)) mark(d, copied);
  }
  mark_facets(mark);
  for (const NodeId n : tree_.nodes()) {
    if (tree_.mesh(n).dimension() == 1 && mesh_.dimension() > 1) mark_curve(n, found, mark);
    if (tree_.mesh(n).dimension() == 0) mark_points(n, mark);
  }
  share_with_copies(found);
  strata_ = std::move(found);
}

// What lies at one of several preimages lies at all of them.
void Strata::share_with_copies(std::vector<std::uint8_t>& found) const {
  for (Index v = 0; v < found.size(); ++v) {
    if (!(found[v] & copied)) continue;
    copies_.collect(tree_, node_, mesh_.dart_of(0, v), 0);
    for (const Copy& c : copies_.of(node_)) found[v] |= found[mesh_.vertex(c.dart)];
  }
}

// Walls, the sides of what stays, and in a surface the edges that are not plain.
template <class Mark>
void Strata::mark_facets(const Mark& mark) const {
  const int d = mesh_.dimension();
  for (Index f = 0; f < mesh_.capacity(d); ++f) {
    if (!mesh_.is_live(d, f)) continue;
    const Dart facet = mesh_.dart_of(d, f);
    const auto mark_corners = [&](Dart s, int k, int strata) {
      constexpr Permutation first[4] = {
          {}, permutation(1, 0, 2, 3), permutation(2, 0, 1, 3), permutation(3, 0, 1, 2)};
      for (int i = 0; i <= k; ++i) mark(mesh_.reorder(s, first[i]), strata);
    };
    if (facet_stays(f)) mark_corners(facet, d, fixed);
    for (const Permutation p : faces_around(d, d - 1, -1)) {
      const Dart side = mesh_.reorder(facet, p);
      if (d == 3 && is_wall(side)) mark_corners(side, 2, wall_stays(side) ? on_face | fixed : on_face);
      if (d == 2 && !is_plain(side)) mark_corners(side, 1, on_curve);
    }
  }
}

// A vertex is regular if just one vertex of curves lies over it, and that is no end.
template <class Mark>
void Strata::mark_curve(NodeId n, const std::vector<std::uint8_t>& found, const Mark& mark) const {
  const Mesh& curves = tree_.mesh(n);
  for (Index v = 0; v < curves.capacity(0); ++v) {
    if (!curves.is_live(0, v) || curves.dart_of(0, v) == no_dart) continue;
    const Dart d = curves.dart_of(0, v);
    visit_images(n, d, 0, [&](Dart image) {
      const bool meets = mesh_.dimension() == 3 && (found[mesh_.vertex(image)] & on_curve) != 0;
      mark(image, meets || curves.is_boundary(d, 0) ? on_curve | fixed : on_curve);
    });
  }
  for (Index e = 0; e < curves.capacity(1); ++e) {
    if (!curves.is_live(1, e) || !stays(n, e)) continue;
    visit_images(n, curves.dart_of(1, e), 1, [&](Dart image) {
      mark(image, fixed);
      mark(mesh_.reorder(image, exchange_ends), fixed);
    });
  }
}

template <class Mark>
void Strata::mark_points(NodeId n, const Mark& mark) const {
  const Mesh& points = tree_.mesh(n);
  for (Index v = 0; v < points.capacity(0); ++v)
    if (points.is_live(0, v)) visit_images(n, points.dart_of(0, v), 0, [&](Dart d) { mark(d, fixed); });
}

// The simplices of this mesh that are the same as one of mesh n.
template <class Visit>
void Strata::visit_images(NodeId n, Dart d, int k, const Visit& visit) const {
  copies_.collect(tree_, n, d, k);
  for (const Copy& c : copies_.of(node_)) visit(c.dart);
}

}  // namespace multimesh
