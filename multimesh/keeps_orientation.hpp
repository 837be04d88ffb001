// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "multimesh/coordinates.hpp"
#include "multimesh/geometry/keeps_side.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// The facets of a mesh keep the exact sign of their orientation in these coordinates, wherever in the tree
/// an operation is asked for. There are two kinds.
///
/// Of a mesh in space, tetrahedra or triangles as seen against a normal: refuses operations after which a
/// facet around the vertex or edge has negative or no volume (or area). Facets that are inverted before must
/// be kept from it by their owner.
///
/// Of charts, triangles of the plane: each triangle keeps its side, and does not vanish (KeepsSide). Charts
/// may be mirrored, and triangles be on the wrong side: they stay there. One without area may come to the
/// side of all others around. Moves are not judged: who moves a vertex asks allows().
///
/// Collapses and swaps of charts are judged before they are done. Cost: the star of the vertex, per preimage.
class KeepsOrientation final : public Invariant {
 public:
  /// Of a mesh in space. Both must outlive it.
  explicit KeepsOrientation(const Coordinates& positions, const Vec3& normal = {0, 0, 1});
  template <class T>
  explicit KeepsOrientation(VertexAttribute<T>& positions, const Vec3& normal = {0, 0, 1})
      : KeepsOrientation(std::make_unique<CoordinatesOf<T>>(positions), nullptr, normal) {}
  /// Of charts. Cost: linear
  KeepsOrientation(const Coordinates& places, const Mesh& charts);
  template <class T>
  KeepsOrientation(VertexAttribute<T>& places, const Mesh& charts)
      : KeepsOrientation(std::make_unique<CoordinatesOf<T>>(places), &charts) {}

  bool before(const Event& event) override;
  bool after(const Event& event) override;

  // --- for who would rather not ask for what will be refused: charts
  /// Whether a vertex may move to `to`; triangles that contain `without` are left out.
  bool allows(const Mesh& charts, Dart vertex, const Vec3& to, Index without = no_index);
  bool allows_swap(const Mesh& charts, Dart edge);

 private:
  /// Triangles by their side: those around an edge before a split, and around the new vertices after it.
  struct Sides {
    std::size_t left = 0, right = 0, none = 0, unseen = 0;
  };

  KeepsOrientation(std::unique_ptr<Coordinates> own, const Mesh* charts, const Vec3& normal = {0, 0, 1});
  bool is_positive(const Mesh& mesh, Dart facet, Index replaced, const Vec3& by) const;
  bool is_positive_around(const Mesh& mesh, Dart d, int k);
  bool allows_merged(const Mesh& mesh, Dart end, Index other, const Vec3& place);
  bool allows_collapse(const Event& event);
  Corners<3> triangle(const Mesh& mesh, Dart d) const;
  int common_side(const Mesh& mesh) const;
  Sides count_sides(const Event& event, int k);
  bool halved(const Sides& after) const;

  std::unique_ptr<Coordinates> own_;
  const Coordinates& positions_;
  bool charts_ = false;
  Vec3 normal_;
  KeepsSide keeps_;
  Sides before_split_;
  DartBuffer star_;
};

}  // namespace multimesh
