// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tetgen/delaunay.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

#include "adapters/tetgen/background_points.hpp"
#include "adapters/tetgen/tetgen_header.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

// TetGen's predicates keep the bounds of their filters in global variables.
std::mutex& tetgen_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// The tetrahedra of distinct points in a box that is not flat; corners number the given points. This is the
/// part of TetGen that neither crashes nor aborts.
std::vector<int> delaunay_of(const std::vector<Point>& points) {
  ::tetgenio in, out;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[points.size() * 3];
  for (std::size_t i = 0; i < points.size(); ++i) std::copy_n(points[i].data(), 3, in.pointlist + 3 * i);

  char quiet[] = "QNF";  // no output, no copy of the points, no faces
  const std::lock_guard lock(tetgen_mutex());
  try {
    ::tetrahedralize(quiet, &in, &out);
  } catch (int code) {
    throw std::runtime_error("TetGen stopped with code " + std::to_string(code));
  }
  std::vector<int> corners(out.tetrahedronlist,
                           out.tetrahedronlist + 4 * std::ptrdiff_t{out.numberoftetrahedra});
  // Exact; below 0 is what we call positive. TetGen's predicates depend on the last call, hence the lock.
  for (std::size_t t = 0; t < corners.size(); t += 4) {
    const auto at = [&](std::size_t k) { return in.pointlist + 3 * std::ptrdiff_t{corners[t + k]}; };
    const double side = ::orient3d(at(0), at(1), at(2), at(3));
    if (side == 0) throw std::runtime_error("TetGen made a flat tetrahedron of points");
    if (side > 0) std::swap(corners[t], corners[t + 1]);
  }
  return corners;
}

}  // namespace

DelaunayMesh delaunay(std::span<const Point> points, const DelaunayOptions& options) {
  constexpr std::size_t most = 50'000'000;  // seven tetrahedra per point, four int indices each
  if (points.size() > most) throw InputError("too many points: at most " + std::to_string(most));
  const Box box = background_box(points, options);
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
  const std::vector<int> corners = delaunay_of(distinct);
  mesh.tets.vertices = static_cast<Index>(mesh.points.size());
  mesh.tets.corners.reserve(corners.size());
  for (const int c : corners) mesh.tets.corners.push_back(source[static_cast<std::size_t>(c)]);
  return mesh;
}

}  // namespace multimesh::tetgen
