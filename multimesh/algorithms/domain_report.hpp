// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/algorithms/tet_topology.hpp"
#include "multimesh/domains/tet_domain.hpp"

namespace multimesh {

struct RegionReport {
  std::size_t tets = 0;
  double volume = 0;
};

/// All meshes of a domain; none for those that it does not have. The tetrahedra are joined again where the
/// domain cut them; surface and curves are as the domain has them.
struct DomainReport {
  TetTopology tets;
  std::map<TetDomain::Tag, RegionReport> regions;
  std::size_t inverted_tets = 0;      ///< with negative or no volume, in floating-point arithmetic
  double min_dihedral = 0;            ///< smallest angle between two faces of a tetrahedron, radians
  std::optional<MeshReport> surface;  ///< its components are the sheets
  std::map<TetDomain::Tag, std::size_t> patches;  ///< triangles of the surface
  std::optional<MeshReport> curves;
  std::map<TetDomain::Tag, std::size_t> curve_tags;  ///< edges of the curves
  std::size_t fixed_points = 0;
  std::map<TetDomain::Tag, std::size_t> fixed_tags;  ///< of those
};

/// Cost: sorting
DomainReport report(const TetDomain& domain);
/// The same, if the topology of domain.tagged() is already known.
DomainReport report(const TetDomain& domain, TetTopology joined);

}  // namespace multimesh
