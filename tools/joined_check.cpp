// SPDX-License-Identifier: BSD-3-Clause
#include "tools/joined_check.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/error.hpp"

namespace multimesh::tools {

namespace {

/// How far repeated rounding may have displaced points.
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

template <class Write>
std::vector<std::string> write_or_keep_aside(const std::filesystem::path& output,
                                             const std::vector<std::string>& faults, const Write& write) {
  if (faults.empty()) return write(output);
  const auto aside = beside(output);
  write(aside);
  std::string message = output.string() + ": not written, for the mesh is not what it was (";
  for (const std::string& f : faults) message += (&f == &faults.front() ? "" : "; ") + f;
  throw InputError(message + "). The result is kept in " + aside.string() +
                   "; please report this with the input");
}

}  // namespace

std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output, const TetTopology& before,
                                            DomainResult after, const files::DomainGroups& groups,
                                            const files::DomainWriteOptions& options, double displacement) {
  const double moved = std::max(displacement, rounding_of(after.lists));
  return write_or_keep_aside(output, differences(before, after.topology, moved),
                             [&](const std::filesystem::path& path) {
                               return files::write_domain(path, std::move(after.lists), groups, options);
                             });
}

std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output,
                                            const SurfaceTopology& before, const TexturedSurface& surface,
                                            const files::SurfaceFile& file) {
  return write_or_keep_aside(
      output, differences(before, topology_of(surface)),
      [&](const std::filesystem::path& path) { return files::write_surface(path, surface, file); });
}

std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output, const TileTopology& before,
                                            const TileTopology& after, const PeriodicDomain& domain,
                                            const files::DomainGroups& groups,
                                            const io::SimplexWriteOptions& options, double sizes) {
  return write_or_keep_aside(
      output, differences(before, after, sizes),
      [&](const std::filesystem::path& path) { return files::write_tile(path, domain, groups, options); });
}

}  // namespace multimesh::tools
