// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/embedding.hpp"

#include "multimesh/column.hpp"
#include "multimesh/domains/surface_invariants.hpp"
#include "multimesh/domains/textured_surface/data.hpp"

namespace multimesh {

namespace {

/// A new edge would be soft.
class HardEdgesStay final : public Invariant {
 public:
  explicit HardEdgesStay(const std::vector<char>& hard) : Invariant("hard edges stay"), hard_(hard) {}
  bool before(const Event& event) override {
    if (event.operation != Operation::flip) return true;
    const Mesh& root = event.tree.mesh(NodeId::root);
    return hard_[root.simplex(event.copies[0].dart, 1)] == 0;
  }

 private:
  const std::vector<char>& hard_;
};

}  // namespace

Embedding TexturedSurface::embedding() {
  Data& d = *data_;
  CurveKinds seams = no_curve;
  Embedding e(*d.tree);
  e.set(LegalityOptions{.contact = true});
  e.add_coordinates(e.add<VertexAttribute<Vec3>>(NodeId::root, *d.positions), Embedding::Kind::space);
  for (std::size_t set = 0; set < d.textures.size(); ++set) {
    auto& texcoords = e.add<VertexAttribute<Vec2>>(d.textures[set], *d.texcoords[set]);
    e.add_coordinates(texcoords, Embedding::Kind::chart);
    e.add<SeamsStayOpen>(texcoords);
    seams |= seam_of(set);
  }
  if (d.curves)
    e.mark_seams(*d.curves, [kinds = d.curve_kinds, seams](Index c) { return ((*kinds)[c] & ~seams) == 0; });
  if (d.colors) e.add<VertexAttribute<Vec3>>(NodeId::root, *d.colors);
  if (d.hard) {
    e.add<Column<char>>(NodeId::root, 1, *d.hard, ColumnRules<char>::unite());
    e.add<HardEdgesStay>(*d.hard);
  }
  if (d.report.copied_vertices > 0) e.add<CopiesStayApart>(d.tree->mesh(NodeId::root), *d.source_position);
  return e;
}

}  // namespace multimesh
