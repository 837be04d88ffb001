// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tetgen/delaunay.hpp"

#include <string>

#include "adapters/tetgen/background_points.hpp"
#include "adapters/tetgen/worker_call.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "adapters/tetgen/worker_path.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

DelaunayMesh delaunay_in(const Box& box, std::span<const Point> points, const DelaunayOptions& options) {
  const std::vector<Point> added = background_points(points, box, options);
  DelaunayMesh mesh;
  mesh.merged_to = first_equal(points);
  mesh.points.assign(points.begin(), points.end());
  mesh.points.insert(mesh.points.end(), added.begin(), added.end());

  std::vector<Point> distinct;
  std::vector<Index> source;
  for (Index i = 0; i < mesh.points.size(); ++i) {
    if (i < points.size() && mesh.merged_to[i] != i) continue;
    distinct.push_back(mesh.points[i]);
    source.push_back(i);
  }
  const WorkerOptions worker{worker_path(), std::chrono::steady_clock::time_point::max(), 0};
  const RawTetrahedra made = call_worker({distinct, {}}, "QF", worker);  // no output, no faces
  mesh.tets.vertices = static_cast<Index>(mesh.points.size());
  mesh.tets.corners.reserve(4 * made.tets.size());
  for (const auto& t : made.tets)
    for (const Index v : t) {
      if (v >= source.size())
        throw WorkerError(WorkerError::Reason::bad_reply, "TetGen added points of its own");
      mesh.tets.corners.push_back(source[v]);
    }
  return mesh;
}

}  // namespace

// An assertion of TetGen's point location fails where planes of the box and the grid pass through points in
// special places: then another box is tried.
DelaunayMesh delaunay(std::span<const Point> points, const DelaunayOptions& options) {
  constexpr std::size_t most = 50'000'000;  // seven tetrahedra per point, four int indices each
  if (points.size() > most) throw InputError("too many points: at most " + std::to_string(most));
  for (unsigned attempt = 0;; ++attempt) try {
      return delaunay_in(background_box(points, options, attempt), points, options);
    } catch (const WorkerError& e) {
      if (e.reason() != WorkerError::Reason::signal || attempt + 1 == boxes) throw;
    }
}

}  // namespace multimesh::tetgen
