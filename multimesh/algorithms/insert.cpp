// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insert.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "multimesh/algorithms/insertion/fronts.hpp"
#include "multimesh/algorithms/insertion/thinning.hpp"
#include "multimesh/error.hpp"

namespace multimesh {

namespace {

using insertion::Cells;
using insertion::Counts;
using insertion::Front;
using insertion::Polygon;
using insertion::Polygons;
using insertion::SegmentWalk;
using insertion::Thinning;

/// Points are taken out again when they have become more by this factor.
constexpr double growth = 1.2;
/// New points per triangle, and for the planes that cross the grid.
constexpr std::size_t points_per_triangle = 50, points_of_grid = 200'000;

FacetList merged(const TriangleSoup& soup, const BackgroundMesh& background) {
  FacetList list = soup.triangles;
  for (Index& v : list.corners) {
    if (v >= background.merged_to.size()) throw UsageError("insert: the background lacks points of the soup");
    v = background.merged_to[v];
  }
  return list;
}

class Insertion {
 public:
  Insertion(const TriangleSoup& soup, const BackgroundMesh& background, const InsertOptions& options)
      : options_(options),
        polygons_(insertion::make_polygons(soup.points, merged(soup, background), soup.labels,
                                           options.merge_coplanar)),
        cells_(background.tets, background.points),
        walk_(cells_, options.snap, counts_),
        front_(cells_, walk_, options.snap, counts_),
        points_of_soup_(static_cast<Index>(soup.points.size())),
        most_points_(options.most_points > 0 ? options.most_points
                                             : points_per_triangle * soup.triangles.size() + points_of_grid),
        thinning_(cells_, static_cast<Index>(background.points.size())),
        live_(background.points.size()),
        next_thinning_(grown()) {
    for (Index i = 0; i < polygons_.all.size(); ++i)
      for (const Index t : polygons_.all[i].triangles)
        for (const Index v : soup.triangles.facet(t)) cells_.add_plane(background.merged_to[v], i);
  }

  Arrangement run() {
    insert_segments();
    insert_polygons();
    thin();
    Arrangement result;
    result.report = report();
    find_again(result);  // segments are straight only before rounding
    result.report.unrounded = options_.round ? cells_.round(points_of_soup_) : result.report.exact_points;
    list_tets(result);
    for (Polygon& p : polygons_.all) result.triangles.push_back(std::move(p.triangles));
    return result;
  }

 private:
  void insert_segments() {
    const std::size_t n = polygons_.segments.size();
    for (std::size_t i = 0; i < n; ++i) {
      walk_.insert(polygons_.segments[i][0], polygons_.segments[i][1], polygons_.beside[i]);
      go_on(0.5 * double(i) / double(n));
    }
  }

  void insert_polygons() {
    const std::size_t n = polygons_.all.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (front_.cover(polygons_.all[i], static_cast<Index>(i), true).empty())
        throw UsageError("insert: a segment was lost");
      go_on(0.5 + 0.5 * double(i) / double(n));
    }
  }

  // Between segments or polygons.
  void go_on(double share) {
    if (live_points() > next_thinning_) {
      thin();
      next_thinning_ = grown();
    }
    if (live_points() > live_ + most_points_)
      throw InputError("inserting the triangles takes more than " + std::to_string(most_points_) +
                       " new points: simplify the surface first, or allow more");
    if (options_.progress && ++steps_ % 1024 == 0) options_.progress(share);
  }

  void thin() {
    if (options_.thin) removed_ += thinning_.run();
  }
  std::size_t live_points() const { return live_ + counts_.points() - removed_; }
  std::size_t grown() const { return static_cast<std::size_t>(growth * static_cast<double>(live_points())); }

  InsertReport report() const {
    InsertReport r;
    r.polygons = polygons_.all.size();
    r.segments = polygons_.segments.size();
    r.degenerate = polygons_.degenerate;
    r.split_faces = counts_.faces;
    r.split_edges = counts_.edges;
    r.crossings = counts_.planes;
    r.swapped = counts_.swaps;
    r.snapped = counts_.snapped;
    r.removed = removed_;
    r.exact_points = cells_.exact_points();
    for (Index v = 0; v < cells_.size(); ++v)
      if (cells_.mesh().is_live(0, v)) r.bits = std::max(r.bits, cells_.point(v).bits());
    return r;
  }

  // The second pass: nothing may have to be split.
  void find_again(Arrangement& result) {
    std::map<std::array<Index, 3>, std::vector<Arrangement::Cover>> faces;
    std::map<std::array<Index, 3>, std::array<Index, 3>> as_first;
    for (Index i = 0; i < polygons_.all.size(); ++i) {
      const auto found = front_.cover(polygons_.all[i], i, false);
      if (found.empty()) throw UsageError("insert: polygon " + std::to_string(i) + " is not made of faces");
      for (const Front::Face& f : found) {
        std::array<Index, 3> key = f;
        std::ranges::sort(key);
        const auto& first = as_first.try_emplace(key, f).first->second;
        faces[key].push_back({i, !is_rotation(first, f)});
      }
    }
    result.faces = {2, static_cast<Index>(cells_.size()), {}};
    result.begin.push_back(0);
    for (const auto& [key, covers] : faces) {
      const auto& v = as_first.at(key);
      result.faces.corners.insert(result.faces.corners.end(), v.begin(), v.end());
      result.covers.insert(result.covers.end(), covers.begin(), covers.end());
      result.begin.push_back(result.covers.size());
    }
  }

  static bool is_rotation(const std::array<Index, 3>& v, const std::array<Index, 3>& w) {
    const auto i = static_cast<std::size_t>(std::ranges::find(w, v[0]) - w.begin());
    return w[(i + 1) % 3] == v[1];
  }

  void list_tets(Arrangement& result) {
    const tet::TetMesh& mesh = cells_.mesh();
    for (Index v = 0; v < cells_.size(); ++v) result.points.push_back(cells_.point(v));
    result.tets = {3, static_cast<Index>(cells_.size()), {}};
    for (Index t = 0; t < mesh.capacity(3); ++t) {
      if (!mesh.is_live(3, t)) continue;
      const Index* v = mesh.corners(t);
      if (cells_.orientation(v[0], v[1], v[2], v[3]) <= 0)
        throw UsageError("insert: tetrahedron " + std::to_string(t) + " is flat or inverted");
      result.tets.corners.insert(result.tets.corners.end(), v, v + 4);
    }
  }

  const InsertOptions& options_;
  Counts counts_;
  Polygons polygons_;
  Cells cells_;
  SegmentWalk walk_;
  Front front_;
  Index points_of_soup_;
  std::size_t most_points_, steps_ = 0, removed_ = 0;
  Thinning thinning_;
  std::size_t live_;  // before
  std::size_t next_thinning_;
};

}  // namespace

Arrangement insert(const TriangleSoup& soup, const BackgroundMesh& background, const InsertOptions& options) {
  return Insertion(soup, background, options).run();
}

}  // namespace multimesh
