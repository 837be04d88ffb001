// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/algorithms/tet_domain.hpp"

namespace multimesh {

/// What a tetrahedral mesh is. Counted over live simplices; isolated vertices are left out.
struct TetReport {
  std::size_t vertices = 0, edges = 0, faces = 0, tets = 0;
  std::size_t components = 0;
  long euler_characteristic = 0;
  std::size_t boundary_components = 0;
  long boundary_euler_characteristic = 0;
  // Betti numbers of the solid, with `components`, by the counts above: right for a manifold in space.
  long handles() const noexcept { return static_cast<long>(components) + cavities() - euler_characteristic; }
  long cavities() const noexcept {
    return static_cast<long>(boundary_components) - static_cast<long>(components);
  }
};

TetReport report_tets(const tet::TetMesh& mesh);

struct RegionReport {
  std::size_t tets = 0;
  double volume = 0;
};

/// All meshes of a domain; none where it has none.
struct DomainReport {
  TetReport tets;
  std::map<TetDomain::Tag, RegionReport> regions;
  std::size_t inverted_tets = 0;      ///< of negative or no volume, by floating-point arithmetic
  double min_dihedral = 0;            ///< smallest angle between two faces of a tetrahedron, radians
  std::optional<MeshReport> surface;  ///< its components are the sheets
  std::map<TetDomain::Tag, std::size_t> patches;  ///< triangles of the surface
  std::optional<MeshReport> curves;
  std::map<TetDomain::Tag, std::size_t> curve_tags;  ///< edges of the curves
};

/// Cost: linear, but for the counting of edges.
DomainReport report(const TetDomain& domain);

}  // namespace multimesh
