// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/fingerprint.hpp"

#include <array>
#include <bit>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::test {

namespace {

class Words {
 public:
  void put(std::uint64_t w) { words_.push_back(w); }
  void put(int w) { words_.push_back(static_cast<std::uint32_t>(w)); }

  void connectivity(const OpenMesh::PolyConnectivity& om) {
    put(om.n_vertices()), put(om.n_edges()), put(om.n_faces());
    for (const auto v : om.all_vertices())
      put(om.halfedge_handle(v).idx()), put(std::uint64_t{om.status(v).bits()});
    for (const auto e : om.all_edges()) put(std::uint64_t{om.status(e).bits()});
    for (const auto f : om.all_faces())
      put(om.halfedge_handle(f).idx()), put(std::uint64_t{om.status(f).bits()});
    for (const auto h : om.all_halfedges()) {
      put(om.to_vertex_handle(h).idx()), put(om.face_handle(h).idx());
      put(om.next_halfedge_handle(h).idx()), put(om.prev_halfedge_handle(h).idx());
    }
  }

  /// Which slots are dead, and corners and neighbours of the others: the contents of a dead slot that is
  /// reused are not restored. Internal state of the mesh (the order in which it reuses slots) shows in later
  /// operations.
  void connectivity(const tet::TetMesh& mesh) {
    put(std::uint64_t{mesh.capacity(0)}), put(std::uint64_t{mesh.capacity(3)});
    for (Index v = 0; v < mesh.capacity(0); ++v) {
      const bool live = mesh.is_live(0, v);
      put(std::uint64_t{live}), put(std::uint64_t{code(mesh.dart_of(0, v))});
      put(std::uint64_t{live && mesh.dart_of(0, v) != no_dart && mesh.is_boundary(mesh.dart_of(0, v), 0)});
      put(std::uint64_t{mesh.is_locked(v)});
    }
    for (Index t = 0; t < mesh.capacity(3); ++t) {
      put(std::uint64_t{mesh.is_live(3, t)});
      if (!mesh.is_live(3, t)) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        put(std::uint64_t{mesh.corners(t)[i]});
        put(std::uint64_t{code(mesh.switch_dart(tet::TetMesh::dart(t, opposite[i]), 3))});
      }
    }
  }

  void connectivity(const Mesh& mesh) {
    if (const auto* tets = dynamic_cast<const tet::TetMesh*>(&mesh)) return connectivity(*tets);
    connectivity(
        const_cast<openmesh::Connectivity&>(dynamic_cast<const openmesh::Connectivity&>(mesh)).openmesh());
  }

  void map(const MultiMesh& tree, NodeId n) {
    const Mesh& mesh = tree.mesh(n);
    const int k = mesh.dimension();
    for (Index f = 0; f < mesh.capacity(k); ++f) {
      put(std::uint64_t{code(mesh.anchor(f).own)}), put(std::uint64_t{code(mesh.anchor(f).parent)});
    }
    const Mesh& above = tree.mesh(tree.parent(n));
    for (Index s = 0; s < above.capacity(k); ++s)
      if (above.is_live(k, s) && above.dart_of(k, s) != no_dart)
        put(std::uint64_t{tree.facet_over(n, above.dart_of(k, s))});
  }

  /// Of all slots; of a tetrahedral mesh, which uses them again, those of live vertices.
  void points(const Mesh& mesh, const std::vector<Point3>& values) {
    for (Index v = 0; v < values.size(); ++v)
      if (mesh.dimension() < 3 || mesh.is_live(0, v))
        for (std::size_t i = 0; i < 3; ++i) put(std::bit_cast<std::uint64_t>(values[v][i]));
  }

  std::vector<std::uint64_t> take() { return std::move(words_); }

 private:
  /// Orderings with each corner last.
  static constexpr std::array<Permutation, 4> opposite{permutation(1, 2, 3, 0), permutation(0, 2, 3, 1),
                                                       permutation(0, 1, 3, 2), Permutation{}};
  std::vector<std::uint64_t> words_;
};

}  // namespace

std::vector<std::uint64_t> fingerprint(Tree& tree) {
  Words words;
  for (const NodeId n : tree.tree->nodes()) {
    words.connectivity(tree.tree->mesh(n));
    if (n != NodeId::root) words.map(*tree.tree, n);
    words.points(tree.tree->mesh(n), tree.points(n));
  }
  return words.take();
}

}  // namespace multimesh::test
