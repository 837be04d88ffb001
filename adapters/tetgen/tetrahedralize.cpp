// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/tetrahedralize.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "adapters/tetgen/regions.hpp"
#include "adapters/tetgen/surface_check.hpp"
#include "adapters/tetgen/worker_call.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "adapters/tetgen/worker_path.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

void check(const TetrahedralizeOptions& o) {
  const auto is_bound = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!is_bound(o.max_volume)) throw UsageError("max_volume is not a volume");
  if (!is_bound(o.edge_length)) throw UsageError("edge_length is not a length");
  if (!(o.radius_edge_ratio == 0 || (o.radius_edge_ratio >= 1.1 && o.radius_edge_ratio <= 1e6)))
    throw UsageError("radius_edge_ratio is neither 0 nor in [1.1, 1e6]");
  if (!(o.min_dihedral >= 0 && o.min_dihedral <= 25))
    throw UsageError("min_dihedral is not in [0, 25] degrees");
  if (!(o.time_limit.count() > 0)) throw UsageError("time_limit is not positive");
}

/// As C's own locale writes it: the caller may have another.
std::string number(double x, std::chars_format format) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, x, format, 6);
  return {text, end.ptr};
}

std::string switches(const TetrahedralizeOptions& o) {
  // M: neither triangles in a plane nor points that are close are merged. Each triangle keeps its marker.
  std::string s = o.split_surface ? "pQM" : "pQMY";
  double volume = o.max_volume;
  if (o.edge_length > 0) {
    const double regular = std::pow(o.edge_length, 3) / (6 * std::sqrt(2.0));
    volume = volume > 0 ? std::min(volume, regular) : regular;
  }
  if (volume > 0 || o.radius_edge_ratio > 0 || o.min_dihedral > 0) {
    // A volume alone would bring a ratio of 2 with it.
    const double ratio = o.radius_edge_ratio > 0 ? o.radius_edge_ratio : 1000;
    s += "q" + number(ratio, std::chars_format::fixed) + "/" +
         number(o.min_dihedral, std::chars_format::fixed);
  }
  if (volume > 0) s += "a" + number(volume, std::chars_format::scientific);
  return s;
}

std::chrono::steady_clock::time_point deadline(const TetrahedralizeOptions& o) {
  constexpr std::chrono::duration<double> most = std::chrono::hours(24 * 365);  // what the clock can count
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::min(o.time_limit, most));
}

/// The surface as the worker sees it: only the points that triangles use.
struct Surface {
  std::vector<Index> used;  ///< ascending
  std::vector<Point> points;
  std::vector<Index> corners;

  Surface(std::span<const Point> all, const FacetList& triangles) : used(triangles.corners) {
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<Index> number(all.size(), no_index);
    for (const Index v : used) number[v] = static_cast<Index>(points.size()), points.push_back(all[v]);
    for (const Index v : triangles.corners) corners.push_back(number[v]);
  }
};

/// Why it failed: triangles that intersect are the most frequent reason. Else the failure itself.
[[noreturn]] void explain(const WorkerError& error, const Surface& surface, const WorkerOptions& options) {
  using Reason = WorkerError::Reason;
  if (error.reason() == Reason::missing || error.reason() == Reason::time_out ||
      error.reason() == Reason::memory)
    throw error;
  std::vector<std::array<Index, 2>> pairs;
  try {
    pairs = find_intersections(surface.points, surface.corners, options);
  } catch (const WorkerError&) {
    throw error;
  }
  if (pairs.empty())
    throw WorkerError(error.reason(),
                      std::string(error.what()) + "; no two triangles were found to intersect");
  const Point& near = surface.points[surface.corners[3 * pairs[0][0]]];
  const auto shown = [](double x) { return number(x, std::chars_format::general); };
  throw InputError("the surface intersects itself: triangles " + std::to_string(pairs[0][0]) + " and " +
                   std::to_string(pairs[0][1]) + (pairs.size() > 1 ? ", among others," : "") + " near (" +
                   shown(near[0]) + ", " + shown(near[1]) + ", " + shown(near[2]) + "); " + error.what());
}

bool is_kept(int winding, Keep keep) {
  return keep == Keep::all || (keep == Keep::even_odd ? winding % 2 != 0 : winding != 0);
}

/// Gives points and tetrahedra the numbers of the caller, and leaves out what is not kept.
class Collector {
 public:
  Collector(std::span<const Point> all, const Surface& surface, const RawTetrahedra& raw)
      : raw_(raw), number_(raw.points.size(), no_index) {
    result_.points.assign(all.begin(), all.end());
    std::copy(surface.used.begin(), surface.used.end(), number_.begin());
  }

  Tetrahedralization collect(Regions regions, Keep keep) {
    std::vector<Index> region_number(regions.winding.size(), no_index);
    for (std::size_t r = 0; r < regions.winding.size(); ++r) {
      if (!is_kept(regions.winding[r], keep)) continue;
      region_number[r] = static_cast<Index>(result_.winding.size());
      result_.winding.push_back(regions.winding[r]);
      volume_ += regions.volume[r];
    }
    for (std::size_t t = 0; t < raw_.tets.size(); ++t) {
      const Index region = region_number[regions.of_tet[t]];
      if (region == no_index) continue;
      for (const Index v : raw_.tets[t]) result_.tets.corners.push_back(number(v));
      result_.region.push_back(region);
    }
    for (SurfaceFace& face : regions.faces)
      for (Index& v : face.corners) v = number(v);
    result_.faces = std::move(regions.faces);
    result_.tets.vertices = static_cast<Index>(result_.points.size());
    result_.volume = static_cast<double>(volume_);
    return std::move(result_);
  }

 private:
  Index number(Index v) {
    if (number_[v] == no_index) {
      number_[v] = static_cast<Index>(result_.points.size());
      result_.points.push_back(raw_.points[v]);
    }
    return number_[v];
  }

  const RawTetrahedra& raw_;
  std::vector<Index> number_;
  Tetrahedralization result_;
  long double volume_ = 0;
};

}  // namespace

Tetrahedralization tetrahedralize(std::span<const Point> points, const FacetList& triangles,
                                  const TetrahedralizeOptions& options) {
  check(options);
  check_closed_surface(points, triangles);
  const Surface surface(points, triangles);
  const WorkerOptions worker{options.worker.empty() ? worker_path() : options.worker, deadline(options),
                             options.memory_limit};
  try {
    const RawTetrahedra raw = call_worker(surface.points, surface.corners, switches(options), worker);
    if (raw.points.size() < surface.points.size() ||
        !std::equal(surface.points.begin(), surface.points.end(), raw.points.begin()))
      throw WorkerError(WorkerError::Reason::bad_result, "TetGen moved points of the surface");
    Regions regions = find_regions(raw, surface.corners, options.split_surface);
    return Collector(points, surface, raw).collect(std::move(regions), options.keep);
  } catch (const WorkerError& error) {
    explain(error, surface, worker);
  }
}

}  // namespace multimesh::tetgen
