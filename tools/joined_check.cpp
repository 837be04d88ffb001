// SPDX-License-Identifier: BSD-3-Clause
#include "tools/joined_check.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/error.hpp"

namespace multimesh::tools {

namespace {

/// By how far repeated rounding may have displaced points.
double rounding_of(const TaggedTetrahedra& tets) {
  double largest = 0;
  for (const auto& p : tets.points)
    for (const double x : p) largest = std::max(largest, std::abs(x));
  return 1e-14 * largest;
}

std::filesystem::path beside(const std::filesystem::path& output) {
  auto path = output;
  const bool zipped = path.extension() == ".gz";
  if (zipped) path.replace_extension();
  const auto extension = path.extension();
  path.replace_extension();
  path += ".rejected";
  path += extension;
  if (zipped) path += ".gz";
  return path;
}

void write_or_keep_aside(const std::filesystem::path& output, const std::vector<std::string>& faults,
                         const Write& write) {
  if (faults.empty()) return write(output);
  const auto aside = beside(output);
  write(aside);
  std::string message = output.string() + ": not written, for the mesh is not what it was (";
  for (const std::string& f : faults) message += (&f == &faults.front() ? "" : "; ") + f;
  throw InputError(message + "). The result is kept in " + aside.string() +
                   "; please report this with the input");
}

}  // namespace

void write_if_same_mesh(const std::filesystem::path& output, const TetTopology& before,
                        const TetDomain& domain, const Write& write, double displacement) {
  const TaggedTetrahedra joined = domain.tagged();
  const double moved = std::max(displacement, rounding_of(joined));
  write_or_keep_aside(output, differences(before, topology_of(joined), moved), write);
}

void write_if_same_mesh(const std::filesystem::path& output, const SurfaceTopology& before,
                        const TexturedSurface& surface, const Write& write) {
  write_or_keep_aside(output, differences(before, topology_of(surface)), write);
}

}  // namespace multimesh::tools
