// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/legality.hpp"

#include <algorithm>

#include "multimesh/faces.hpp"

namespace multimesh {

std::string_view to_string(Check check) noexcept {
  switch (check) {
    case Check::none:
      return "none";
    case Check::link_condition:
      return "link condition";
    case Check::gluing:
      return "gluing";
    case Check::placement:
      return "placement";
    case Check::contact:
      return "contact";
    case Check::locked:
      return "locked";
    case Check::flip:
      return "flip";
    case Check::invariant:
      return "invariant";
  }
  return "?";
}

CollapseVerdict Legality::collapse(const MultiMesh& tree, const Copies& copies,
                                   const LegalityOptions& options) {
  CollapseVerdict verdict;
  if (!link_conditions(tree, copies, verdict)) return verdict;
  for (std::uint32_t i = 0; i < copies.size(); ++i) {
    for (const NodeId below : tree.descendants(copies[i].node))
      if (!no_gluing(tree, copies, i, below, verdict)) return verdict;
    if (options.contact && !no_contact(tree, copies, i, verdict)) return verdict;
  }
  if (verdict.hold_a && verdict.hold_b) verdict.refusal = {Check::placement, NodeId::root, {}};
  return verdict;
}

// L, and what is cheap to check at the same time: locks and strata.
bool Legality::link_conditions(const MultiMesh& tree, const Copies& copies, CollapseVerdict& verdict) {
  bool locked_a = false, locked_b = false;
  for (const Copy& c : copies.all()) {
    const Mesh& mesh = tree.mesh(c.node);
    if (!mesh.link_condition(c.dart)) {
      verdict.refusal = {Check::link_condition, c.node, {}};
      return false;
    }
    const Dart at_b = mesh.reorder(c.dart, exchange_ends);
    locked_a |= mesh.is_locked(mesh.vertex(c.dart));
    locked_b |= mesh.is_locked(mesh.vertex(at_b));
    if (locked_a && locked_b) {
      verdict.refusal = {Check::locked, c.node, {}};
      return false;
    }
    const bool rim_a = mesh.is_boundary(c.dart, 0), rim_b = mesh.is_boundary(at_b, 0);
    verdict.prefer_a |= rim_a && !rim_b;
    verdict.prefer_b |= rim_b && !rim_a;
  }
  verdict.hold_a |= locked_a;
  verdict.hold_b |= locked_b;
  return true;
}

namespace {

Index end_vertex(const Mesh& mesh, Dart e, End end) {
  return mesh.vertex(end == End::a ? e : mesh.reorder(e, exchange_ends));
}

}  // namespace

// Whether an end of an edge has a preimage in a mesh below that no preimage of the edge has.
bool Legality::unmatched(const MultiMesh& tree, std::span<const Copy> over, NodeId from, NodeId below_node,
                         Dart at_end, End end) {
  if (over.empty()) return tree.is_covered(from, at_end, 0, below_node);
  const Mesh& below = tree.mesh(below_node);
  // An interior vertex of a mesh of the same dimension covers the whole star of its image: it is the only
  // preimage.
  if (below.dimension() == tree.mesh(from).dimension())
    for (const Copy& c : over)
      if (!below.is_boundary(end == End::a ? c.dart : below.reorder(c.dart, exchange_ends), 0)) return false;
  found_.clear();
  tree.preimages_below(from, at_end, 0, below_node, found_);
  return std::any_of(found_.begin(), found_.end(), [&](Dart v) {
    return std::none_of(over.begin(), over.end(),
                        [&](const Copy& c) { return end_vertex(below, c.dart, end) == below.vertex(v); });
  });
}

// U for the simplices x of the link, vertices and (in dimension 3) edges: whether both a-x and b-x have
// preimages that no preimage of a-b-x has. If a-b-x is a facet, of which the mesh below has at most one, and
// the mesh below has it, its link condition already covers this.
bool Legality::link_gluing(const MultiMesh& tree, const Copy& e, NodeId below_node) {
  const Mesh& above = tree.mesh(e.node);
  const Mesh& below = tree.mesh(below_node);
  const int d = above.dimension();
  const auto has_unmatched = [&](Dart side, Permutation in_facet, int k) {
    unmatched_.clear();
    tree.preimages_below(e.node, side, k, below_node, unmatched_);
    return std::any_of(unmatched_.begin(), unmatched_.end(), [&](Dart s) {
      return std::none_of(found_.begin(), found_.end(), [&](Dart whole) {
        return below.same_simplex(s, below.reorder(whole, in_facet), k);
      });
    });
  };
  above.star(e.dart, 1, star_);
  for (const Dart t : star_)  // (a, b, x, ..)
    for (int k = 1; k < d && k <= below.dimension(); ++k)
      for (const Permutation p : faces_around(d, k + 1, 1)) {
        const Dart whole = above.reorder(t, p);  // begins with a, b, x
        found_.clear();
        if (k + 1 == d) {
          if (tree.is_covered(e.node, whole, d, below_node)) continue;
        } else if (k < below.dimension()) {
          tree.preimages_below(e.node, whole, k + 1, below_node, found_);
        }
        if (has_unmatched(above.reorder(whole, without_b(k)), without_b(k), k) &&
            has_unmatched(above.reorder(whole, without_a(k)), without_a(k), k))
          return true;
      }
  return false;
}

namespace {

/// The copies in `below` that lie over copy i; they are contiguous.
std::span<const Copy> copies_over(const Copies& copies, NodeId below, std::uint32_t i) {
  const auto lies_over = [&](const Copy& c) {
    std::uint32_t above = c.above;
    while (above > i) above = copies[above].above;
    return above == i;
  };
  const auto all = copies.of(below);
  const auto first = std::find_if(all.begin(), all.end(), lies_over);
  return {first, std::find_if_not(first, all.end(), lies_over)};
}

}  // namespace

bool Legality::no_gluing(const MultiMesh& tree, const Copies& copies, std::uint32_t i, NodeId below_node,
                         CollapseVerdict& verdict) {
  const Copy& e = copies[i];
  const auto over = copies_over(copies, below_node, i);
  const Dart at_b = tree.mesh(e.node).reorder(e.dart, exchange_ends);
  const bool free_a = unmatched(tree, over, e.node, below_node, e.dart, End::a);
  const bool free_b = unmatched(tree, over, e.node, below_node, at_b, End::b);
  // If an end has no preimage at all, neither has anything around it.
  const bool both = (free_a || !over.empty()) && (free_b || !over.empty());
  if ((free_a && free_b) || (both && link_gluing(tree, e, below_node))) {
    verdict.refusal = {Check::gluing, below_node, {}};
    return false;
  }
  verdict.hold_a |= free_a;
  verdict.hold_b |= free_b;
  // Two preimages that share an end (the end of a slit): all of them become one vertex, which has one set
  // of values only if it is placed at the shared end.
  const Mesh& below = tree.mesh(below_node);
  for (std::size_t m = 0; m < over.size(); ++m)
    for (std::size_t n = m + 1; n < over.size(); ++n) {
      const auto shared = [&](End end) {
        return end_vertex(below, over[m].dart, end) == end_vertex(below, over[n].dart, end);
      };
      verdict.hold_a |= shared(End::a);
      verdict.hold_b |= shared(End::b);
    }
  return true;
}

namespace {

// False if no label can be new on one side: everything that has a label has it at its vertices, and a label
// that all facets over the edge have is on the simplices in between, too.
template <class Covered>
bool may_touch(const Mesh& mesh, Dart a, Dart b, const DartBuffer& over, std::span<const NodeId> children,
               const Covered& covered) {
  const int d = mesh.dimension();
  bool any_a = mesh.is_boundary(a, 0), any_b = mesh.is_boundary(b, 0);
  for (const NodeId child : children) {
    if (any_a && any_b) break;
    if (std::all_of(over.begin(), over.end(), [&](Dart t) { return covered(t, d, child); })) continue;
    any_a = any_a || covered(a, 0, child);
    any_b = any_b || covered(b, 0, child);
  }
  return any_a && any_b;
}

}  // namespace

// C: with labels(s) the children whose image contains s, and one more on the boundary, for s = e and each
// s = e*x the labels of one of its two sides a*.., b*.. must be among its own.
bool Legality::no_contact(const MultiMesh& tree, const Copies& copies, std::uint32_t i,
                          CollapseVerdict& verdict) {
  const Copy& e = copies[i];
  const Mesh& mesh = tree.mesh(e.node);
  const auto children = tree.children(e.node);
  // Whether a label is on both sides of what will be one simplex, here an `a` and there a `b`, but not on
  // the simplex in between, `both`.
  const auto new_contact = [&](Dart a, Dart b, Dart both, int k) {
    bool extra_a = false, extra_b = false;
    const auto compare = [&](const auto& has_label) {
      if (has_label(both, k + 1)) return;
      extra_a = extra_a || has_label(a, k);
      extra_b = extra_b || has_label(b, k);
    };
    compare([&](Dart d, int j) { return j < mesh.dimension() && mesh.is_boundary(d, j); });
    for (const NodeId child : children)
      compare([&](Dart d, int j) { return tree.is_covered(e.node, d, j, child); });
    return extra_a && extra_b;
  };
  const int d = mesh.dimension();
  const Dart at_b = mesh.reorder(e.dart, exchange_ends);
  mesh.star(e.dart, 1, star_);
  const auto covered = [&](Dart t, int k, NodeId child) { return tree.is_covered(e.node, t, k, child); };
  if (!may_touch(mesh, e.dart, at_b, star_, children, covered)) return true;
  bool touches = new_contact(e.dart, at_b, e.dart, 0);
  if (!touches && d > 1) {
    for (const Dart t : star_)  // (a, b, x, ..)
      for (int k = 1; k < d && !touches; ++k)
        for (const Permutation p : faces_around(d, k + 1, 1)) {
          const Dart whole = mesh.reorder(t, p);
          touches = touches || new_contact(mesh.reorder(whole, without_b(k)),
                                           mesh.reorder(whole, without_a(k)), whole, k);
        }
  }
  if (touches) verdict.refusal = {Check::contact, e.node, {}};
  return !touches;
}

}  // namespace multimesh
