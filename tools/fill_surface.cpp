// SPDX-License-Identifier: BSD-3-Clause
#include "tools/fill_surface.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "adapters/io/weld.hpp"
#include "adapters/tetgen/naming.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"

namespace multimesh::tools {

namespace {

/// Joins points at one place.
void weld(io::SimplexSoup& soup, double tolerance, std::vector<std::string>& warnings) {
  const std::vector<Index> first = io::coincident_points(soup.points, tolerance);
  std::size_t joined = 0;
  for (Index i = 0; i < first.size(); ++i) joined += first[i] != i;
  if (joined == 0) return;
  warnings.push_back(std::to_string(joined) + " points are at the place of another one; joined with it");
  for (auto& block : soup.simplices)
    for (Index& v : block.corners) v = first[v];
}

/// Objects and groups of surface files name what they enclose; groups of other files name only their
/// surfaces.
tetgen::TriangleNames triangle_names(const files::DomainFile& file) {
  tetgen::TriangleNames names;
  names.tags = file.soup.simplices[2].tags;
  names.name_regions = files::is_surface_format(file.path);
  for (const auto& g : file.soup.groups)
    if (g.dimension == 2) names.parts[g.tag] = {g.name, g.object};
  return names;
}

void add_groups(int dimension, const std::vector<tetgen::Naming::Tag>& tags,
                std::vector<io::SimplexSoup::Group>& groups) {
  for (const auto& [tag, name] : tags) {
    const io::SimplexSoup::Group group{dimension, tag, name};
    if (!name.empty() && std::find(groups.begin(), groups.end(), group) == groups.end())
      groups.push_back(group);
  }
}

/// Keeps patches whose triangles are in several groups of the file in these groups, under their present tags.
void keep_groups(const io::SimplexSoup& soup, const tetgen::Tetrahedralization& filled, FilledSurface& out) {
  std::map<TaggedTetrahedra::Tag, TaggedTetrahedra::Tag> before;  // by the tag that a face has now
  for (std::size_t f = 0; f < filled.faces.size(); ++f)
    before.emplace(out.tets.patches[f], soup.simplices[2].tags[filled.faces[f].triangle]);
  std::set<std::int32_t> used;
  for (const io::SimplexSoup::TagSet& set : soup.tag_sets) {
    if (set.dimension != 2) out.groups.tag_sets.push_back(set);
    for (const auto& [now, tag] : before) {
      if (set.dimension != 2 || tag != set.tag) continue;
      std::vector<std::int32_t> groups = set.groups;
      if (now != tag) groups.push_back(now);  // which has a name of its own
      std::ranges::sort(groups);
      used.insert(groups.begin(), groups.end());
      out.groups.tag_sets.push_back({2, now, groups});
    }
  }
  for (const auto& g : soup.groups)
    if (g.dimension == 2 && used.contains(g.tag)) add_groups(2, {{g.tag, g.name}}, out.groups.groups);
}

FilledSurface with_names(tetgen::Tetrahedralization filled, files::DomainFile& file) {
  const tetgen::Naming naming = tetgen::name_parts(filled, triangle_names(file));
  file.warnings.insert(file.warnings.end(), naming.warnings.begin(), naming.warnings.end());
  FilledSurface out;
  TaggedTetrahedra& t = out.tets;
  for (const Index r : filled.region) t.regions.push_back(naming.regions[r].tag);
  for (const tetgen::SurfaceFace& f : filled.faces)
    t.triangles.corners.insert(t.triangles.corners.end(), f.corners.begin(), f.corners.end());
  t.patches = naming.face_tags;
  t.edges.corners = file.soup.simplices[1].corners;
  t.edge_tags = file.soup.simplices[1].tags;
  t.edge_flags = file.soup.simplices[1].flags;
  t.fixed = file.soup.simplices[0].corners;
  t.fixed_tags = file.soup.simplices[0].tags;
  t.fixed_flags = file.soup.simplices[0].flags;
  t.triangles.vertices = t.edges.vertices = static_cast<Index>(filled.points.size());
  t.points = std::move(filled.points);
  t.tets = std::move(filled.tets);
  for (const auto& g : file.soup.groups)
    if (g.dimension < 2) out.groups.groups.push_back(g);
  add_groups(2, naming.patches, out.groups.groups);
  add_groups(3, naming.regions, out.groups.groups);
  keep_groups(file.soup, filled, out);
  return out;
}

}  // namespace

namespace {

/// Advice for the user when TetGen fails on a surface in which it finds no fault.
std::string way_out(const tetgen::WorkerError& e) {
  using Reason = tetgen::WorkerError::Reason;
  const char* const other_triangles =
      "other triangles may help, as `multimesh remesh` makes them; fTetWild fills surfaces that TetGen does "
      "not";
  switch (e.reason()) {
    case Reason::time_out:
      return std::string("; --time-limit gives it more; ") + other_triangles;
    case Reason::memory:
      return "; where --memory-limit was given, more may do; larger tetrahedra need less";
    case Reason::signal:
    case Reason::stopped:
    case Reason::bad_result:
      return std::string("; ") + other_triangles;
    default:
      return {};
  }
}

}  // namespace

FilledSurface fill_surface(files::DomainFile& file, const tetgen::TetrahedralizeOptions& options,
                           double weld_tolerance) {
  const std::string name = file.path.string();
  if (file.soup.simplices[2].size() == 0) throw InputError(name + ": has no triangle");
  weld(file.soup, weld_tolerance, file.warnings);
  const FacetList triangles{2, static_cast<Index>(file.soup.points.size()), file.soup.simplices[2].corners};
  try {
    tetgen::Tetrahedralization filled = tetgen::tetrahedralize(file.soup.points, triangles, options);
    file.warnings.insert(file.warnings.end(), filled.warnings.begin(), filled.warnings.end());
    return with_names(std::move(filled), file);
  } catch (const tetgen::WorkerError& e) {
    throw InputError(name + ": " + e.what() + way_out(e));
  } catch (const InputError& e) {
    throw InputError(name + ": " + e.what());
  }
}

tetgen::Point parse_point(const std::string& text, const std::string& option) {
  tetgen::Point p{};
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, p[i]);
    const bool is_last = i == 2;
    if (error != std::errc() || !std::isfinite(p[i]) || (is_last ? next != end : next == end || *next != ','))
      throw InputError(option + ": '" + text + "' is no point; give x,y,z, as in 0.5,-1,2e-3");
    at = is_last ? next : next + 1;
  }
  return p;
}

tetgen::RegionSeed parse_region_seed(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0)
    throw InputError("--region: '" + text + "' has no name; give NAME:x,y,z");
  return {text.substr(0, colon), parse_point(text.substr(colon + 1), "--region")};
}

}  // namespace multimesh::tools
