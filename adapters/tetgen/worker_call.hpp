// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

struct WorkerOptions {
  std::filesystem::path program;
  std::chrono::steady_clock::time_point deadline;
  std::uint64_t memory_limit = 0;  ///< bytes; 0: none
};

/// TetGen's result for a surface, not verified yet.
struct RawTetrahedra {
  std::vector<Point> points;
  std::vector<std::array<Index, 4>> tets;
  struct Face {
    std::array<Index, 3> corners;
    Index triangle;  ///< no_index: none, at the border
  };
  std::vector<Face> faces;  ///< on the surface and at the border, in no order or orientation
};

/// The input of a worker.
struct WorkerInput {
  std::span<const Point> points;
  std::span<const Index> corners;  ///< of triangles, \#F x 3
  std::span<const Point> holes{};  ///< a point in each region that is to be left empty
};

/// Makes a worker tetrahedralize a surface with these switches of TetGen. \throw WorkerError
RawTetrahedra call_worker(const WorkerInput& input, const std::string& switches,
                          const WorkerOptions& options);

/// Makes a worker find triangles that intersect others, and returns the first pairs. \throw WorkerError
std::vector<std::array<Index, 2>> find_intersections(const WorkerInput& input, const WorkerOptions& options);

}  // namespace multimesh::tetgen
