// SPDX-License-Identifier: BSD-3-Clause
// Private to the files of this folder.
#pragma once

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/tet/simplex_map.hpp"

namespace multimesh {

/// The lists are properties of their meshes: they grow with them, and are compacted with them.
struct TetDomain::Data {
  std::unique_ptr<MultiMesh> tree;
  tet::TetMesh* mesh = nullptr;
  tet::Property<Point>* points = nullptr;
  tet::Property<Tag>* regions = nullptr;
  tet::Property<Index>* copy_of = nullptr;  // per vertex with copies: its input point's index + 1; else 0
  tet::SimplexProperty<char>* copied_edges = nullptr;  // edges that occur more than once, or are sides of a
                                                       // parted face
  tet::SimplexProperty<char>* parted_faces = nullptr;  // faces that occur more than once
  tet::Property<Tag>* point_tags = nullptr;
  tet::Property<std::uint8_t>* tet_flags = nullptr;
  std::optional<NodeId> surface, curves, fixed_points;
  std::vector<Tag>* patches = nullptr;  // per triangle of the surface; so are the flags
  std::vector<std::uint8_t>* triangle_flags = nullptr;
  std::vector<char>* implied = nullptr;    // per triangle of the surface: present only as boundary
  std::vector<Tag>* curve_tags = nullptr;  // per edge of the curves; so are the flags
  std::vector<std::uint8_t>* curve_flags = nullptr;
  std::vector<Tag>* fixed_tags = nullptr;  // per fixed point; so are the flags
  std::vector<std::uint8_t>* fixed_flags = nullptr;
  TetDomainReport report;
};

/// How the root relates to the input.
struct JoinedMesh {
  std::vector<Index> source;  // per root vertex: its input point
  tet::SimplexMap beyond;     // of parted faces, by their root vertices: a tetrahedron of another copy
};

/// Makes the root.
JoinedMesh add_tetrahedra(const TaggedTetrahedra& input, TetDomain::Data& out);
/// Finds the edges and faces of which the cut has made several copies.
void find_copies(TetDomain::Data& out, JoinedMesh& joined);
void add_surface(const TaggedTetrahedra& input, const TetDomainOptions& options, const JoinedMesh& joined,
                 TetDomain::Data& out);
/// Flags of simplex i of a list; i == no_index: of a simplex that is not in it.
inline std::uint8_t flags_of(const std::vector<std::uint8_t>& flags, Index i) {
  if (i == no_index) return unlisted_simplex;
  return flags.empty() ? std::uint8_t{0} : flags[i];
}

/// \pre the surface, if any, has been added. \return per vertex of the root, whether sheets touch there
/// with no curve through, or the surface and a curve that does not run on it
std::vector<bool> add_curves(const TaggedTetrahedra& input, const TetDomainOptions& options,
                             const JoinedMesh& joined, TetDomain::Data& out);
/// Those that the input lists, those where something touches, and copies.
void add_fixed_points(const TaggedTetrahedra& input, const JoinedMesh& joined,
                      const std::vector<bool>& touching, TetDomain::Data& out);

}  // namespace multimesh
