// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/fill_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "adapters/tetgen/worker_path.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

/// In the format of C's own locale: the caller may have set another.
std::string number(double x, std::chars_format format) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, x, format, 6);
  return {text, end.ptr};
}

/// M: neither coplanar triangles nor close points are merged, so each triangle keeps its marker. J: points
/// keep their numbers, also where nothing is filled.
std::string surface_switches(const TetrahedralizeOptions& o) {
  return o.split_surface ? "pQMJ" : "pQMJY";
}

}  // namespace

void check_options(const TetrahedralizeOptions& o) {
  const auto is_bound = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!is_bound(o.max_volume)) throw UsageError("max_volume is not a volume");
  if (!is_bound(o.edge_length)) throw UsageError("edge_length is not a length");
  if (!(o.radius_edge_ratio == 0 || (o.radius_edge_ratio >= 1.1 && o.radius_edge_ratio <= 1e6)))
    throw UsageError("radius_edge_ratio is neither 0 nor in [1.1, 1e6]");
  if (!(o.min_dihedral >= 0 && o.min_dihedral <= 25))
    throw UsageError("min_dihedral is not in [0, 25] degrees");
  if (!(o.time_limit.count() > 0)) throw UsageError("time_limit is not positive");
}

double volume_bound(const TetrahedralizeOptions& o) {
  if (!(o.edge_length > 0)) return o.max_volume;
  const double regular = std::pow(o.edge_length, 3) / (6 * std::sqrt(2.0));
  return o.max_volume > 0 ? std::min(o.max_volume, regular) : regular;
}

bool refines(const TetrahedralizeOptions& o) {
  return volume_bound(o) > 0 || o.radius_edge_ratio > 0 || o.min_dihedral > 0;
}

std::string hull_switches(const TetrahedralizeOptions& o) {
  return surface_switches(o) + "c";
}

std::string refining_switches(const TetrahedralizeOptions& o) {
  // A volume alone would imply a ratio of 2.
  const double ratio = o.radius_edge_ratio > 0 ? o.radius_edge_ratio : 1000;
  std::string s = surface_switches(o) + "q" + number(ratio, std::chars_format::fixed) + "/" +
                  number(o.min_dihedral, std::chars_format::fixed);
  if (const double volume = volume_bound(o); volume > 0)
    s += "a" + number(volume, std::chars_format::scientific);
  return s;
}

WorkerOptions worker_options(const TetrahedralizeOptions& o) {
  constexpr std::chrono::duration<double> most = std::chrono::hours(24 * 365);  // what the clock can count
  const auto deadline =
      std::chrono::steady_clock::now() +
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::min(o.time_limit, most));
  return {o.worker.empty() ? worker_path() : o.worker, deadline, o.memory_limit};
}

}  // namespace multimesh::tetgen
