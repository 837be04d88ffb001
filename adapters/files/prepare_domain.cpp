// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/matching_sides.hpp"
#include "adapters/io/weld.hpp"
#include "adapters/io/weld_simplices.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::files {

std::size_t count_coincident(const io::SimplexSoup& soup) {
  const std::vector<std::uint32_t> joins = io::coincident_points(soup.points);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < joins.size(); ++i) count += joins[i] != i;
  return count;
}

std::size_t count_periodic_pairs(const io::SimplexSoup& soup) {
  std::size_t pairs = 0;
  for (const auto& link : soup.periodic) pairs += link.points.size();
  return pairs;
}

namespace {

void weld(DomainFile& file, double tolerance) {
  const io::WeldReport r = io::weld_points(file.soup, tolerance);
  const auto tell = [&](std::size_t n, const char* what) {
    if (n > 0) file.warnings.push_back(std::to_string(n) + " " + what);
  };
  tell(r.points, "points were welded to another one");
  tell(r.collapsed, "elements had corners that were welded; left out");
  tell(r.doubled, "elements became another one with the same tag; left out");
  if (file.soup.dimension() < 0)
    throw InputError(file.path.string() + ": no element is left after welding; give a smaller --weld");
}

void weld_or_tell(DomainFile& file, const DomainReadOptions& options) {
  if (options.weld) return weld(file, *options.weld);
  if (options.no_weld || file.soup.simplices[3].size() == 0) return;
  if (const std::size_t n = count_coincident(file.soup); n > 0)
    file.warnings.push_back(std::to_string(n) +
                            " points are at the place of another one, and the mesh is open between them; "
                            "--weld 0 joins them");
}

void check_periodic(DomainFile& file, const DomainReadOptions& options) {
  const std::size_t pairs = count_periodic_pairs(file.soup);
  if (pairs > 0 && !options.no_periodic)
    throw PeriodicMeshError(
        file.path.string() + ": the mesh is periodic ($Periodic, " + std::to_string(pairs) +
        " pairs of points), and its sides would not be kept equal; improve and remesh keep them "
        "with --periodic, --no-periodic takes it as "
        "any other mesh");
  if (pairs > 0)
    file.warnings.push_back("the periodic links are dropped, " + std::to_string(pairs) + " pairs of points");
  if (pairs > 0 || options.no_periodic || options.sides_stay) return;
  std::string axes;
  for (const std::string& axis : io::axes_with_matching_sides(file.soup.points))
    axes += (axes.empty() ? "" : ", ") + axis;
  if (!axes.empty())
    file.warnings.push_back("opposite sides of the mesh match (" + axes +
                            "), as those of a periodic tile; that is not kept. --no-periodic takes this "
                            "warning away");
}

}  // namespace

void prepare(DomainFile& file, const DomainReadOptions& options) {
  weld_or_tell(file, options);
  check_periodic(file, options);
}

}  // namespace multimesh::files
