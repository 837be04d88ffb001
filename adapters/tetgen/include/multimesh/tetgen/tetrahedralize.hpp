// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "multimesh/tetgen/facets.hpp"

namespace multimesh::tetgen {

/// Which of the regions that the surface bounds are kept. The winding number of a region is how often the
/// surface goes round it: 0 outside, one more behind each triangle whose normal points outwards. Where the
/// orientation of triangles is inconsistent, the region they enclose counts as one more.
enum class Keep : std::uint8_t {
  winding,   ///< where it is not 0: a cavity is a hole if its triangles are oriented against the outer ones
  even_odd,  ///< where it is odd: every other region from outside, whatever the orientation of the components
  all        ///< all but the outside: surfaces further inside become interfaces
};

/// A point of a region, and the region's name.
struct RegionSeed {
  std::string name;
  Point point{};
};

struct TetrahedralizeOptions {
  Keep keep = Keep::winding;
  std::vector<RegionSeed> regions{};  ///< these regions are kept, regardless of `keep`, and named
  std::vector<Point> holes{};         ///< the regions of these points are left empty
  /// Upper bound on the volume of tetrahedra; 0: none. Next to a surface that may not be split, larger ones
  /// remain where the bound would require new points close to the surface.
  double max_volume = 0;
  /// Bounds the volume by that of the regular tetrahedron of this edge length; 0: no bound.
  double edge_length = 0;
  /// Target ratio of circumscribed sphere's radius to shortest edge; 0: none, else at least 1.1; 2 is what
  /// TetGen certainly reaches away from sharp angles and long surface edges.
  double radius_edge_ratio = 0;
  /// Target dihedral angle, in degrees, in [0, 25]; 0: none. TetGen does not guarantee it.
  double min_dihedral = 0;
  /// Whether new points may be put on the surface. If not, each triangle is a face of the result. If so,
  /// TetGen adds many where dihedral angles are small, takes longer, and gives up on some surfaces that it
  /// could otherwise fill.
  bool split_surface = false;
  /// TetGen is stopped after this time.
  std::chrono::duration<double> time_limit = std::chrono::minutes(10);
  /// Address space that the worker may use, in bytes; 0: no bound. It needs about 1 KB per tetrahedron.
  std::uint64_t memory_limit = 0;
  /// The program multimesh-tetgen-worker; empty: searched for, see worker_path().
  std::filesystem::path worker{};
};

/// A face of the result that lies on the surface, oriented like its triangle.
struct SurfaceFace {
  std::array<Index, 3> corners{};
  Index facet = no_index;
  Index triangle = no_index;  ///< the first one of the facet
  Sides regions{};            ///< no_index: nothing is there
};

/// The input's points come first, in its order; those that no triangle uses have no tetrahedra. All others
/// are corners of tetrahedra.
struct Tetrahedralization : TetrahedraList {
  std::vector<Index> region;  ///< per tetrahedron: a connected part that the surface separates from others
  std::vector<int> winding;   ///< per region
  std::vector<std::string> names;     ///< per region, by its seed; empty: none
  std::vector<SurfaceFace> faces;     ///< by ascending facet; one each unless split_surface
  Facets facets;                      ///< the triangles of which each facet is made
  double volume = 0;                  ///< of everything that was kept
  std::vector<std::string> warnings;  ///< about the input, and what was done; one sentence each
};

/// Fills with tetrahedra what triangles enclose. Any number of triangles may meet in corners and whole edges,
/// in any orientation; those with equal corners count as one. They separate space into regions, numbered in
/// the order of the triangles; the outside is left out. Triangles that separate nothing stay as sheets
/// inside. Those with a repeated corner, or without area up to the rounding of coordinates, are left out;
/// where TetGen fails, up to that of single precision. TetGen works in a separate process, so that its
/// crashes, its memory and its endless loops do not affect the caller. May be called from several threads,
/// also at the same time. Nothing is printed. The result is verified: all tetrahedra are positive and meet in
/// faces, the triangles are faces (or covered by faces), volumes are those that the surface encloses (1e-9
/// relative). Cost: about 0.5 s for 10 000 triangles that are not split, some surfaces far more.
/// \throw InputError naming a triangle, edge or point if the surface encloses nothing, or intersects itself,
/// or if a seed is in no region; WorkerError if TetGen ended otherwise, or returned a wrong result;
/// UsageError if an option is out of its range
Tetrahedralization tetrahedralize(std::span<const Point> points, const FacetList& triangles,
                                  const TetrahedralizeOptions& options = {});

}  // namespace multimesh::tetgen
