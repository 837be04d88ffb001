// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tetgen/tetrahedralize.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <set>
#include <stdexcept>

#include "adapters/tetgen/choice.hpp"
#include "adapters/tetgen/fill_options.hpp"
#include "adapters/tetgen/filling.hpp"
#include "adapters/tetgen/surface_check.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

/// Gives points, tetrahedra and regions the numbers of the caller, and leaves out what is not kept.
class Collector {
 public:
  Collector(std::span<const Point> all, const Surface& surface, const Filling& filling, const Choice& choice)
      : filling_(filling), number_(filling.raw.points.size(), no_index) {
    result_.points.assign(all.begin(), all.end());
    std::copy(surface.used().begin(), surface.used().end(), number_.begin());
    for (std::size_t r = 0; r < choice.kept.size(); ++r) {
      region_number_.push_back(choice.kept[r] ? static_cast<Index>(result_.winding.size()) : no_index);
      if (!choice.kept[r]) continue;
      result_.winding.push_back(choice.winding[r]);
      result_.names.push_back(choice.names[r]);
      volume_ += filling.regions.volume[r];
    }
  }

  Tetrahedralization collect(Facets facets) {
    const RawTetrahedra& raw = filling_.raw;
    for (std::size_t t = 0; t < raw.tets.size(); ++t) {
      const Index r = region(filling_.regions.of_tet[t]);
      if (r == no_index) continue;
      for (const Index v : raw.tets[t]) result_.tets.corners.push_back(number(v));
      result_.region.push_back(r);
    }
    for (const FacetFace& face : filling_.regions.faces) {
      const Sides& sides = filling_.regions.sides[face.facet];
      SurfaceFace own{face.corners,
                      face.facet,
                      facets.sources_of(face.facet)[0].triangle,
                      {region(sides.behind), region(sides.before)}};
      if (own.regions == Sides{}) continue;
      for (Index& v : own.corners) v = number(v);
      result_.faces.push_back(own);
    }
    result_.facets = std::move(facets);
    result_.tets.vertices = static_cast<Index>(result_.points.size());
    result_.volume = static_cast<double>(volume_);
    return std::move(result_);
  }

 private:
  Index region(Index r) const { return r == no_index ? r : region_number_[r]; }
  Index number(Index v) {
    if (number_[v] == no_index) {
      number_[v] = static_cast<Index>(result_.points.size());
      result_.points.push_back(filling_.raw.points[v]);
    }
    return number_[v];
  }

  const Filling& filling_;
  std::vector<Index> number_, region_number_;
  Tetrahedralization result_;
  long double volume_ = 0;
};

/// Fills what was chosen once more, with points added inside.
Filling refine(const Filling& first, const Choice& choice, const Surface& surface,
               const TetrahedralizeOptions& options, const WorkerOptions& worker) {
  Filling filling = surface.fill(refining_switches(options),
                                 {options.split_surface, without_region(first.regions.sides, choice.kept)},
                                 worker, hole_points(first, choice.kept));
  renumber(filling.regions, first.regions);
  return filling;
}

/// What a number format makes of a distance of 0, at worst.
template <class Number>
double rounding(std::span<const Point> points, const FacetList& triangles) {
  double largest = 0;
  for (const Index v : triangles.corners)
    for (const double x : points[v]) largest = std::max(largest, std::abs(x));
  return 4 * static_cast<double>(std::numeric_limits<Number>::epsilon()) * largest;
}

Tetrahedralization fill(std::span<const Point> points, const Facets& facets,
                        const TetrahedralizeOptions& options, const WorkerOptions& worker) {
  if (facets.size() == 0) throw InputError("no triangle has an area");
  const Surface surface(points, facets);
  Filling filling = surface.fill(hull_switches(options), {options.split_surface}, worker);
  const Choice choice = choose(filling, facets, options);
  if (refines(options)) filling = refine(filling, choice, surface, options, worker);
  Tetrahedralization result = Collector(points, surface, filling, choice).collect(facets);
  result.warnings = choice.warnings;
  return result;
}

}  // namespace

Tetrahedralization tetrahedralize(std::span<const Point> points, const FacetList& triangles,
                                  const TetrahedralizeOptions& options) {
  check_options(options);
  check_points(points, triangles);
  const WorkerOptions worker = worker_options(options);
  // Triangles that rounding alone has kept from being flat are often folded over their neighbours. Files may
  // have rounded to single precision; or mean what is as small as the rounding of doubles.
  std::exception_ptr failure;
  std::set<std::size_t> tried;
  for (const double height : {rounding<double>(points, triangles), 0.0, rounding<float>(points, triangles)}) {
    const Facets facets = make_facets(points, triangles, height);
    if (!tried.insert(facets.flat).second) continue;
    try {
      return fill(points, facets, options, worker);
    } catch (const std::runtime_error&) {
      if (!failure) failure = std::current_exception();
    }
  }
  std::rethrow_exception(failure);
}

}  // namespace multimesh::tetgen
