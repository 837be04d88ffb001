// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::test {

/// How a file lists the squares between voxels.
enum class Listing {
  once,      ///< each once, in any orientation
  twice,     ///< from each side that is not empty, with the normal away from it
  by_solid,  ///< the same, solid after solid
};

/// Cubes of materials in a grid, 0 being empty, and walls between some that have the same material. The
/// regions are found by filling voxels.
class Voxels {
 public:
  Voxels(int size, std::vector<int> materials);
  static Voxels random(int size, int materials, double filled, std::mt19937& random);
  /// Puts walls between neighbours of the same material, but not in empty space.
  void add_walls(double share, std::mt19937& random);
  /// Puts a wall between a voxel and the next one along an axis.
  void add_wall(const std::array<int, 3>& voxel, int axis) { walls_.insert({voxel, axis}); }

  struct Surface {
    std::vector<tetgen::Point> points;
    FacetList triangles;
    std::vector<int> material;  ///< per triangle: the one that lists it
  };
  Surface surface(Listing listing, std::mt19937& random) const;

  /// Per voxel, a number of its connected part; parts that reach the outside have the number 0.
  std::vector<int> parts() const;
  int material(const std::array<int, 3>& voxel) const;
  /// The voxel that a point is in.
  std::array<int, 3> voxel_at(const tetgen::Point& p) const;
  int index(const std::array<int, 3>& voxel) const;
  int size() const { return size_; }

 private:
  bool is_wall(const std::array<int, 3>& voxel, int axis) const;

  int size_;
  std::vector<int> materials_;
  std::set<std::pair<std::array<int, 3>, int>> walls_;
};

}  // namespace multimesh::test
