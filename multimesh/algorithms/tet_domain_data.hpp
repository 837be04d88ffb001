// SPDX-License-Identifier: BSD-3-Clause
// Private to the files tet_domain*.cpp.
#pragma once

#include "adapters/openmesh/connectivity.hpp"
#include "multimesh/algorithms/tet_domain.hpp"

namespace multimesh {

/// The lists are properties of their meshes: they grow with them, and move along when they are compacted.
struct TetDomain::Data {
  std::unique_ptr<MultiMesh> tree;
  tet::TetMesh* mesh = nullptr;
  tet::Property<Point>* points = nullptr;
  tet::Property<Tag>* regions = nullptr;
  tet::Property<Index>* copy_of = nullptr;  // of vertices that are one input point: its index + 1; else 0
  std::optional<NodeId> surface, curves;
  std::vector<Tag>* patches = nullptr;     // per triangle of the surface
  std::vector<char>* implied = nullptr;    // per triangle of the surface: it is there as boundary only
  std::vector<Tag>* curve_tags = nullptr;  // per edge of the curves
  TetDomainReport report;

  OpenMesh::PolyConnectivity& openmesh(NodeId n) {
    return dynamic_cast<openmesh::Connectivity&>(tree->mesh(n)).openmesh();
  }
};

/// Makes the root. \return per root vertex, its input point
std::vector<Index> add_tetrahedra(const TaggedTetrahedra& input, TetDomain::Data& out);
void add_surface(const TaggedTetrahedra& input, const TetDomainOptions& options,
                 const std::vector<Index>& source, TetDomain::Data& out);
/// \pre the surface, if any, has been added
void add_curves(const TaggedTetrahedra& input, const TetDomainOptions& options,
                const std::vector<Index>& source, TetDomain::Data& out);

}  // namespace multimesh
