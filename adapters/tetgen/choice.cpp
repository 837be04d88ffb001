// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/choice.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "adapters/tetgen/surface_check.hpp"
#include "adapters/tetgen/surface_measure.hpp"
#include "adapters/tetgen/winding.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

std::string text_of(const Point& p) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

/// "3 triangles" or "1 triangle".
std::string counted(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

bool is_kept(int winding, Keep keep) {
  return keep == Keep::all || (keep == Keep::even_odd ? winding % 2 != 0 : winding != 0);
}

/// Whether a point is in a tetrahedron or, up to rounding, at its border.
bool is_in(const RawTetrahedra& raw, const std::array<Index, 4>& tet, const Point& p) {
  std::array<Point, 4> points{p};
  for (const auto& face : outward_faces) {
    for (std::size_t k = 0; k < 3; ++k) points[k + 1] = raw.points[tet[face[k]]];
    if (volume_of(points, {1, 3, 2, 0}) < -least_volume(points, {1, 3, 2, 0})) return false;
  }
  return true;
}

/// The region that a seed names. \throw InputError
Index region_at(const Filling& filling, const Point& p, const std::string& seed) {
  std::set<Index> found;
  for (std::size_t t = 0; t < filling.raw.tets.size(); ++t)
    if (is_in(filling.raw, filling.raw.tets[t], p)) found.insert(filling.regions.of_tet[t]);
  if (found.size() > 1)
    throw InputError("the " + seed + " at " + text_of(p) +
                     " is on a triangle, between two regions: move it inside");
  if (found.empty() || *found.begin() == no_index)
    throw InputError("the " + seed + " at " + text_of(p) + " is in no region that the triangles enclose");
  return *found.begin();
}

void apply_seeds(const Filling& filling, const TetrahedralizeOptions& options, Choice& choice) {
  for (const RegionSeed& seed : options.regions) {
    const Index r = region_at(filling, seed.point, "seed of region " + seed.name);
    if (!choice.names[r].empty() && choice.names[r] != seed.name)
      throw InputError("the seeds of regions " + choice.names[r] + " and " + seed.name +
                       " are in the same region: no triangle separates them");
    choice.names[r] = seed.name;
    choice.kept[r] = true;
  }
  for (const Point& p : options.holes) {
    const Index r = region_at(filling, p, "seed of a hole");
    if (!choice.names[r].empty())
      throw InputError("the seed of a hole at " + text_of(p) + " is in region " + choice.names[r]);
    choice.kept[r] = false;
  }
}

/// Facets that bound no region: what they were meant to enclose is open.
void check_enclosed(const Filling& filling, const Facets& facets) {
  std::size_t outside = 0;
  for (const Sides& s : filling.regions.sides) outside += s.behind == no_index && s.before == no_index;
  if (2 * outside <= facets.size()) return;
  const std::string open = first_open_edge(facets);
  throw InputError((open.empty() ? "the surface encloses nothing" : "the surface is open: " + open) + "; " +
                   (outside == facets.size() ? "nothing is enclosed"
                                             : "most triangles, " + std::to_string(outside) + " of " +
                                                   std::to_string(facets.size()) + ", enclose nothing"));
}

void warn_of_triangles(const Facets& facets, std::vector<std::string>& warnings) {
  if (facets.collapsed > 0)
    warnings.push_back(counted(facets.collapsed, "triangle") + " that repeat a point left out");
  if (facets.flat == 0) return;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(2);
  text << counted(facets.flat, "triangle") << " without area (no higher than " << facets.least_height
       << ") left out";
  if (facets.split > 0)
    text << "; " << counted(facets.split, "neighbour") << " cut where these had joined them to others";
  warnings.push_back(text.str());
}

/// Repeated triangles. One with each orientation is right between two regions.
std::size_t count_repeated(const Facets& facets, const std::vector<Sides>& sides) {
  std::size_t repeated = 0;
  for (Index f = 0; f < facets.size(); ++f) {
    const auto sources = facets.sources_of(f);
    const auto reversed = static_cast<std::size_t>(
        std::count_if(sources.begin(), sources.end(), [](const FacetSource& s) { return s.reversed; }));
    const bool is_between = sides[f].behind != no_index && sides[f].before != no_index;
    repeated += sources.size() - 1 - (reversed > 0 && is_between ? 1 : 0);
  }
  return repeated;
}

void warn_of_facets(const Filling& filling, const Facets& facets, const Choice& choice,
                    std::vector<std::string>& warnings) {
  const auto& sides = filling.regions.sides;
  if (const std::size_t n = count_repeated(facets, sides); n > 0)
    warnings.push_back(counted(n, "triangle") + " with the corners of another one left out");
  const auto is_filled = [&](Index r) { return r != no_index && choice.kept[r]; };
  std::size_t outside = 0, sheets = 0, first = no_index;
  for (Index f = 0; f < sides.size(); ++f) {
    const bool is_outside = !is_filled(sides[f].behind) && !is_filled(sides[f].before);
    if (is_outside && outside++ == 0) first = facets.sources_of(f)[0].triangle;
    sheets += !is_outside && sides[f].behind == sides[f].before;
  }
  if (outside > 0)
    warnings.push_back(counted(outside, "triangle") +
                       " bound nothing that is filled; left out, the first is " + std::to_string(first));
  if (sheets > 0)
    warnings.push_back(counted(sheets, "triangle") + " separate nothing; kept as sheets inside of a region");
}

void warn_of_winding(const Winding& winding, const Choice& choice, const TetrahedralizeOptions& options,
                     std::vector<std::string>& warnings) {
  if (!winding.turned.empty())
    warnings.push_back(counted(winding.turned.size(), "triangle") +
                       " run against the others; taken as if turned round");
  // Regions with seeds are not assumed.
  const auto assumed = std::count_if(winding.assumed.begin(), winding.assumed.end(),
                                     [&](Index r) { return choice.kept[r] && choice.names[r].empty(); });
  if (assumed > 0 && options.keep != Keep::all)
    warnings.push_back("the orientation of the triangles does not tell what is empty: " +
                       counted(static_cast<std::size_t>(assumed), "region") +
                       " that they enclose taken as filled; a hole's seed makes one empty");
}

}  // namespace

Choice choose(const Filling& filling, const Facets& facets, const TetrahedralizeOptions& options) {
  check_enclosed(filling, facets);
  const std::size_t regions = filling.regions.volume.size();
  const Winding winding = find_winding(facets, filling.regions.sides, regions);
  Choice choice;
  choice.winding = winding.numbers;
  choice.names.resize(regions);
  for (const int w : winding.numbers) choice.kept.push_back(is_kept(w, options.keep));
  apply_seeds(filling, options, choice);
  if (std::find(choice.kept.begin(), choice.kept.end(), true) == choice.kept.end())
    throw InputError("no region is left to be filled: all " + std::to_string(regions) + " are empty");
  warn_of_triangles(facets, choice.warnings);
  warn_of_facets(filling, facets, choice, choice.warnings);
  warn_of_winding(winding, choice, options, choice.warnings);
  return choice;
}

std::vector<bool> without_region(const std::vector<Sides>& sides, const std::vector<bool>& kept) {
  const auto is_kept = [&](Index r) { return r != no_index && kept[r]; };
  std::vector<bool> without;
  without.reserve(sides.size());
  for (const Sides& s : sides) without.push_back(!is_kept(s.behind) && !is_kept(s.before));
  return without;
}

std::vector<Point> hole_points(const Filling& filling, const std::vector<bool>& kept) {
  std::vector<std::size_t> largest(kept.size(), 0);
  std::vector<long double> volume(kept.size(), 0);
  for (std::size_t t = 0; t < filling.raw.tets.size(); ++t) {
    const Index r = filling.regions.of_tet[t];
    if (r == no_index || kept[r]) continue;
    const long double v = volume_of(filling.raw.points, filling.raw.tets[t]);
    if (v > volume[r]) largest[r] = t, volume[r] = v;
  }
  std::vector<Point> points;
  for (std::size_t r = 0; r < kept.size(); ++r) {
    if (kept[r]) continue;
    Point& middle = points.emplace_back();
    for (const Index v : filling.raw.tets[largest[r]])
      for (std::size_t i = 0; i < 3; ++i) middle[i] += filling.raw.points[v][i] / 4;
  }
  return points;
}

}  // namespace multimesh::tetgen
