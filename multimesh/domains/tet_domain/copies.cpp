// SPDX-License-Identifier: BSD-3-Clause
// What the cut has made several of. A simplex that occurs more than once has a copied vertex.
#include "multimesh/domains/tet_domain/data.hpp"

namespace multimesh {

using tet::simplex_key;

namespace {

class CopyFinder {
 public:
  CopyFinder(TetDomain::Data& domain, JoinedMesh& joined)
      : domain_(domain), root_(*domain.mesh), joined_(joined) {}

  void mark_faces() {
    for_each_repeated(2, [&](Dart one, Dart other) {
      part(one, other);
      part(other, one);
    });
  }
  void mark_edges() {
    for_each_repeated(1, [&](Dart one, Dart other) {
      mark_edge(one);
      mark_edge(other);
    });
  }

 private:
  void part(Dart face, Dart other) {
    Index v[4];
    root_.vertices(face, v);
    joined_.beyond.set(simplex_key(v, 2), root_.tet(other));
    root_.set_value(*domain_.parted_faces, face, char{1});
    for (const Permutation side : {Permutation{}, permutation(1, 2, 0, 3), permutation(0, 2, 1, 3)})
      mark_edge(root_.reorder(face, side));
  }

  void mark_edge(Dart e) {
    root_.set_value(*domain_.copied_edges, e, char{1});
    for (const Dart end : {e, root_.reorder(e, exchange_ends)}) {
      root_.set_locked(root_.vertex(end), true);
    }
  }

  /// Calls `visit` with each repeated simplex and the first one with the same input points.
  template <class Visit>
  void for_each_repeated(int k, const Visit& visit) const {
    tet::SimplexMap first;
    for (Index s = 0; s < root_.capacity(k); ++s) {
      if (!root_.is_live(k, s)) continue;
      const Dart d = root_.dart_of(k, s);
      Index v[4];
      root_.vertices(d, v);
      bool copied = false;
      for (int i = 0; i <= k; ++i) {
        copied = copied || (*domain_.copy_of)[v[i]] != 0;
        v[i] = joined_.source[v[i]];
      }
      if (!copied) continue;
      const auto key = simplex_key(v, k);
      if (const Index known = first.find(key); known != no_index) {
        visit(root_.dart_of(k, known), d);
      } else {
        first.set(key, s);
      }
    }
  }

  TetDomain::Data& domain_;
  tet::TetMesh& root_;
  JoinedMesh& joined_;
};

}  // namespace

void find_copies(TetDomain::Data& out, JoinedMesh& joined) {
  out.copied_edges = &out.mesh->add_simplex_property<char>(1, "copied");
  out.parted_faces = &out.mesh->add_simplex_property<char>(2, "parted");
  if (out.report.copied_vertices == 0) return;
  CopyFinder finder(out, joined);
  finder.mark_faces();
  finder.mark_edges();
}

}  // namespace multimesh
