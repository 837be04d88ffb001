// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/filling.hpp"

#include <algorithm>
#include <sstream>

#include "adapters/tetgen/surface_check.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

/// Explains a failure: intersecting triangles are the most frequent reason; otherwise the failure itself.
[[noreturn]] void explain(const WorkerError& error, const Surface& surface, const WorkerOptions& options) {
  using Reason = WorkerError::Reason;
  if (error.reason() == Reason::missing || error.reason() == Reason::time_out ||
      error.reason() == Reason::memory)
    throw error;
  std::vector<std::array<Index, 2>> pairs;
  try {
    pairs = find_intersections({surface.points(), surface.facets().corners}, options);
  } catch (const WorkerError&) {
    throw error;
  }
  const std::string open = first_open_edge(surface.facets());
  if (pairs.empty())
    throw WorkerError(error.reason(), std::string(error.what()) +
                                          "; no two triangles were found to intersect" +
                                          (open.empty() ? "" : "; the surface is open: " + open));
  const auto triangle = [&](Index f) { return surface.facets().sources_of(f)[0].triangle; };
  const Point& near = surface.points()[surface.facets().facet(pairs[0][0])[0]];
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the surface intersects itself: triangles " << triangle(pairs[0][0]) << " and "
       << triangle(pairs[0][1]) << (pairs.size() > 1 ? ", among others," : "") << " near (" << near[0] << ", "
       << near[1] << ", " << near[2] << "); " << error.what();
  if (!open.empty()) text << "; it is also open: " << open;
  throw InputError(text.str());
}

[[noreturn]] void fail(const std::string& what) {
  throw WorkerError(WorkerError::Reason::bad_result, what);
}

}  // namespace

Surface::Surface(std::span<const Point> all, const Facets& facets) : used_(facets.corners), facets_(facets) {
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  std::vector<Index> number(all.size(), no_index);
  for (const Index v : used_) number[v] = static_cast<Index>(points_.size()), points_.push_back(all[v]);
  for (Index& v : facets_.corners) v = number[v];
}

Filling Surface::fill(const std::string& switches, const RegionOptions& options, const WorkerOptions& worker,
                      std::span<const Point> holes) const {
  try {
    Filling filling;
    filling.raw = call_worker({points_, facets_.corners, holes}, switches, worker);
    const auto& points = filling.raw.points;
    if (points.size() < points_.size() || !std::equal(points_.begin(), points_.end(), points.begin()))
      fail("TetGen moved points of the surface");
    filling.regions = find_regions(filling.raw, facets_, options);
    return filling;
  } catch (const WorkerError& error) {
    explain(error, *this, worker);
  }
}

void renumber(Regions& later, const Regions& first) {
  std::vector<Index> number(later.volume.size(), no_index);
  const auto assign = [&](Index own, Index other) {
    if (own == no_index) return;
    if (other == no_index || (number[own] != no_index && number[own] != other))
      fail("TetGen's result has other regions after points were added");
    number[own] = other;
  };
  for (const FacetFace& face : later.faces) {
    assign(later.sides[face.facet].behind, first.sides[face.facet].behind);
    assign(later.sides[face.facet].before, first.sides[face.facet].before);
  }
  const auto renumbered = [&](Index r) { return r == no_index ? r : number[r]; };
  for (Index& r : later.of_tet) r = renumbered(r);
  for (Sides& s : later.sides) s = {renumbered(s.behind), renumbered(s.before)};
  std::vector<long double> volume(first.volume.size(), 0);
  for (std::size_t r = 0; r < number.size(); ++r) volume[number[r]] += later.volume[r];
  later.volume = std::move(volume);
}

}  // namespace multimesh::tetgen
