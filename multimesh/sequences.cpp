// SPDX-License-Identifier: BSD-3-Clause
// Operations made of splits and collapses: each a transaction of its own, counted as one.
#include <algorithm>
#include <string>
#include <utility>

#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

// Runs `steps`, which end at the first refusal; all is undone then.
template <class Steps>
Outcome Propagation::sequence(Operation operation, const Steps& steps) {
  const Statistics before = statistics_;
  Outcome outcome;
  {
    Transaction transaction(tree_, attributes_, Transaction::Own::yes);
    outcome = steps();
    if (outcome) transaction.commit();
  }
  statistics_ = before;
  ++statistics_.tried;
  if (!outcome) return refuse(outcome.refusal);
  return succeed(operation, outcome.dart, outcome.root, outcome.changed);
}

// Into b, of a vertex that a split of the same operation put in: nothing of what is at b gets a value from
// it.
Outcome Propagation::take_back(NodeId n, Dart e) {
  taking_back_ = true;
  try {
    const Outcome outcome = collapse_inside(n, e, Placement::keep_b());
    taking_back_ = false;
    return outcome;
  } catch (...) {
    taking_back_ = false;
    throw;
  }
}

// Of the mesh of the last collapse: what a dart of before it is called now.
Dart Propagation::after_collapses(NodeId n, Dart d) const {
  for (std::size_t i = copies_.first(n) + copies_.count(n); i-- > copies_.first(n);)
    d = tree_.mesh(n).after_collapse(collapses_[i], d);
  return d;
}

// Of the mesh of the last split, whose edge was the first one of e: e in the half at that end.
Dart Propagation::after_split(NodeId n, Dart e, End end) const {
  const Mesh& mesh = tree_.mesh(n);
  for (std::size_t i = copies_.first(n);; ++i) {
    const SplitRecord& record = splits_[i];
    const Index facet = mesh.facet(e);
    const bool here = std::any_of(record.facets.begin(), record.facets.end(),
                                  [&](const SplitRecord::Halves& h) { return h.old == facet; });
    if (here) return mesh.after_split(record, e, end);
  }
}

namespace {

bool is_above(const MultiMesh& tree, NodeId ancestor, NodeId n) {
  while (n != ancestor && n != NodeId::root) n = tree.parent(n);
  return n == ancestor;
}

}  // namespace

// The edge must be interior in every mesh of dimension 2 or more, and in no mesh of dimension 1. The edge of
// a surface may lie in the boundary of the tetrahedra above, if the faces at it do.
bool Propagation::swappable(NodeId n, Dart e) {
  tree_.require_dart(n, e);
  tree_.require_simplex(n, e, 1);
  copies_.collect(tree_, n, e, 1);
  const auto copies = std::as_const(copies_).all();
  return std::all_of(copies.begin(), copies.end(), [&](const Copy& c) {
    const Mesh& mesh = tree_.mesh(c.node);
    if (mesh.dimension() < 2) return false;
    if (!mesh.is_boundary(c.dart, 1)) return true;
    return tree_.mesh(n).dimension() == 2 && mesh.dimension() == 3 && is_above(tree_, c.node, n) &&
           mesh.is_boundary(tree_.to_ancestor(n, e, c.node), 2);
  });
}

Outcome Propagation::swap_by_split_and_collapse(NodeId n, Dart e) {
  const Operating operating(tree_);
  return swap_in_steps(n, e);
}

Outcome Propagation::swap_in_steps(NodeId n, Dart e) {
  return sequence(Operation::flip, [&]() -> Outcome {
    if (!swappable(n, e)) return {{Check::flip, n, {}}, no_dart, no_dart};
    const Outcome halves = split_inside(n, e, 0.5);
    if (!halves) return halves;
    const Dart to_apex = tree_.mesh(n).reorder(halves.dart, edge_bx);  // (a,c,x,..) -> (c,x,a,..)
    return take_back(n, to_apex);
  });
}

Outcome Propagation::swap_face(NodeId n, Dart f) {
  const Operating operating(tree_);
  return sequence(Operation::flip, [&]() -> Outcome {
    tree_.require_dart(n, f);
    const Mesh& mesh = tree_.mesh(n);
    const Dart beyond = mesh.dimension() == 3 ? mesh.switch_dart(f, 3) : no_dart;
    if (beyond == no_dart) return {{Check::flip, n, {}}, no_dart, no_dart};
    const Index v = mesh.vertex(mesh.reorder(beyond, permutation(3, 0, 1, 2)));
    const Outcome inside = split_simplex_inside(n, f, 2);  // (m,z,x,w)
    if (!inside) return inside;
    const Outcome done = take_back(n, mesh.reorder(inside.dart, permutation(0, 3, 1, 2)));
    if (!done) return done;
    // The new edge w-v.
    mesh.star(done.dart, 0, star_);
    for (const Dart t : star_)
      for (const Permutation p : faces_around(3, 1, 0))
        if (mesh.vertex(mesh.reorder(mesh.reorder(t, p), exchange_ends)) == v)
          return {{}, mesh.reorder(t, p), tree_.to_root(n, mesh.reorder(t, p)), done.changed};
    return done;
  });
}

// Face (x,y,z,..): a vertex c on x-y, a vertex m on z-c; then c goes back into x, and what was split around
// x-y is whole again. Tetrahedron (x,y,z,w): m in its face, a vertex on m-w, then m goes back into x.
Outcome Propagation::split_simplex(NodeId n, Dart d, int k) {
  const Operating operating(tree_);
  return split_simplex_inside(n, d, k);
}

Outcome Propagation::split_simplex_inside(NodeId n, Dart d, int k) {
  tree_.require_dart(n, d);
  const Mesh& mesh = tree_.mesh(n);
  if (k < 1 || k > mesh.dimension())
    throw UsageError("split_simplex: a mesh of dimension " + std::to_string(mesh.dimension()) +
                     " has no such simplices of dimension " + std::to_string(k));
  if (k == 1) {
    Outcome halves = split_inside(n, d, 0.5);
    if (!halves) return halves;
    halves.dart = mesh.reorder(halves.dart, exchange_ends);
    halves.root = halves.changed;
    return halves;
  }
  return sequence(Operation::split, [&]() -> Outcome {
    Dart spoke;  // (z,c,x,..) or (m,w,x,..): the edge to be split
    double t;    // the barycentre on it
    Dart back;   // (m,c,x,..) or (m,q,x,..)
    if (k == 2) {
      const Outcome side = split_inside(n, d, 0.5);
      if (!side) return side;
      spoke = mesh.reorder(side.dart, permutation(2, 1, 0, 3));
      t = 2.0 / 3;
    } else {
      const Outcome face = split_simplex_inside(n, d, 2);  // (m,z,x,w)
      if (!face) return face;
      spoke = mesh.reorder(face.dart, permutation(0, 3, 2, 1));
      t = 0.25;
    }
    const Outcome inside = split_inside(n, spoke, t);
    if (!inside) return inside;
    Dart at_new;
    if (k == 2) {
      at_new = mesh.reorder(inside.dart, exchange_ends);                            // (m,z,x,..)
      back = mesh.reorder(after_split(n, spoke, End::b), permutation(1, 2, 0, 3));  // (c,x,m,..)
    } else {
      at_new = after_split(n, spoke, End::b);                     // (q,w,x,z)
      back = mesh.reorder(inside.dart, permutation(0, 2, 1, 3));  // (m,x,q,z)
    }
    const Outcome done = take_back(n, back);
    if (!done) return done;
    const Dart now = after_collapses(n, at_new), in_root = tree_.to_root(n, now);
    return {{}, now, in_root, in_root};
  });
}

}  // namespace multimesh
