// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// The sizes and the topology of one mesh of a tree. Counts live simplices; isolated vertices are left out.
struct MeshReport {
  int dimension = 2;
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< faces: 0 in dimension 1
  std::size_t components = 0;
  long euler_characteristic = 0;
  std::size_t boundary = 0;  ///< boundary loops (dimension 2) or end points (dimension 1)
  /// For all components together: (2 components - boundary loops - Euler characteristic) / 2. Dimension 2.
  long genus = 0;
};

MeshReport report(const Mesh& mesh);

/// The graph of some of a surface's curves, by vertices of the surface.
struct CurveReport {
  std::size_t edges = 0;
  std::size_t curves = 0;     ///< chains and loops between the points below
  std::size_t ends = 0;       ///< vertices with one such edge
  std::size_t junctions = 0;  ///< vertices with three or more
};
using SeamReport = CurveReport;

/// The edges with at least one of the kinds. Other kinds that begin or end on a curve do not divide it.
CurveReport report_curves(const TexturedSurface& surface, CurveKinds kinds);
/// The seams of a set of texture coordinates: interior edges of the surface at which the set is cut open or
/// ends.
SeamReport report_seams(const TexturedSurface& surface, std::size_t set = 0);
/// Sharp edges, if the surface was made with a feature angle.
CurveReport report_features(const TexturedSurface& surface);

/// A texture besides the first one.
struct UvSetReport {
  MeshReport texture;
  std::optional<SeamReport> seams;
};

/// All meshes of a textured surface; none for those that it does not have.
struct SurfaceReport {
  MeshReport surface;
  std::optional<MeshReport> texture;  ///< of set 0; its components are the charts
  std::optional<SeamReport> seams;    ///< of set 0
  std::optional<CurveReport> features;
  std::vector<UvSetReport> more_uv_sets;
};

SurfaceReport report(const TexturedSurface& surface);

/// How far the triangles of an input, as given, are from manifold.
struct ManifoldReport {
  std::size_t edges_with_three_or_more = 0;
  std::size_t inconsistent_edges = 0;  ///< edges along which two triangles run in the same direction
  std::size_t cut_vertices = 0;        ///< vertices at which the surface had to be cut
};

ManifoldReport report_manifoldness(const TexturedTriangles& input, const TexturedSurface& surface);

}  // namespace multimesh
