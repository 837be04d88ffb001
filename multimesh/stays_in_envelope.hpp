// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "multimesh/coordinates.hpp"
#include "multimesh/geometry/envelope.hpp"
#include "multimesh/geometry/triangle_cover.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// A surface stays within a distance of what it was, and what it was stays within that distance of it,
/// wherever in the tree operations are requested. In a periodic tile distances are those in the torus.
///
/// One direction is the envelope's test of each triangle that changes. For the other, each triangle of the
/// original surface is stored with its witnesses, triangles of the current surface that together are near all
/// of it; when one of them changes, it must find others among those that replace them and those it has
/// elsewhere. Both are proofs up to rounding: what is refused may be within the distance, what is accepted
/// is.
///
/// Its journal must be among the attributes of the operations, after the coordinates'.
class StaysInEnvelope final : public Invariant {
 public:
  /// The surface as it is. `places`: of a mesh of the tree that has all its triangles; not necessarily one
  /// above it. Cost: O(n log n)
  StaysInEnvelope(const MultiMesh& tree, NodeId surface, const Coordinates& places, double distance);

  bool before(const Event& event) override;
  bool after(const Event& event) override;
  Attribute& journal() noexcept { return journal_; }

  /// How far the surface is now from what it was, and that from it: the greatest distances of seven points of
  /// each triangle. Cost: O(n log n)
  std::array<double, 2> measure() const;

  /// Of the original surface, in a tile with its neighbours.
  const spatial::Envelope& envelope() const noexcept { return *envelope_; }

 private:
  class Journal final : public Attribute {
   public:
    Journal(NodeId node, spatial::Witnesses& witnesses) : Attribute(node), witnesses_(witnesses) {}
    void set(Index input, const spatial::Witnesses::Set& set);
    void update(Operation, const VertexChange&) override {}
    Mark mark() const override { return old_.size(); }
    void rollback(Mark mark) override;
    void forget() override { old_.clear(); }

   private:
    spatial::Witnesses& witnesses_;
    std::vector<std::pair<Index, spatial::Witnesses::Set>> old_;
  };
  struct Facet {
    Index index;
    spatial::Triangle triangle;
    bool changed;
  };

  void read_input();
  std::vector<spatial::Triangle> with_neighbours(std::vector<spatial::Triangle> surface) const;
  std::vector<spatial::Triangle> current() const;
  spatial::Triangle triangle(Index facet) const;
  void read_facets(const Event& event, bool after, std::vector<Facet>& facets);
  bool find_witnesses(Index input);
  void add_candidates(Index input, const Vec3& near);
  spatial::Triangle seen(const spatial::Triangle& t, const Vec3& near) const;

  const MultiMesh& tree_;
  const Mesh& mesh_;
  const Coordinates& places_;
  double distance_;
  std::vector<spatial::Triangle> input_;  ///< by facet
  std::optional<spatial::Envelope> envelope_;
  spatial::Witnesses witnesses_;
  Journal journal_;
  spatial::NearTriangles candidates_;
  std::vector<Facet> before_, after_;
  std::vector<Index> inputs_;
  std::vector<std::pair<Index, spatial::Witnesses::Set>> found_;
  DartBuffer one_star_, star_;
  mutable DartBuffer images_;
};

}  // namespace multimesh
