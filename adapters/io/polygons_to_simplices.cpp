// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/polygons_to_simplices.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "multimesh/io/triangulate.hpp"

namespace multimesh::io {

namespace {

/// The tags of triangles, from objects and groups of an OBJ file, or solids of an STL file.
class SectionTags {
 public:
  explicit SectionTags(const PolygonSoup& soup) : soup_(soup) {
    for (const auto& s : soup.sections) objects_of_[s.group].insert(s.object);
  }

  /// 0 for faces that are in no group or object.
  std::int32_t tag(std::size_t face) {
    if (soup_.face_section.empty()) return 0;
    const PolygonSoup::Section& s = soup_.sections[soup_.face_section[face]];
    if (s.object.empty() && s.group.empty()) return 0;
    const auto [at, is_new] =
        tags_.try_emplace({s.object, s.group}, static_cast<std::int32_t>(groups_.size()) + 1);
    if (is_new) groups_.push_back({2, at->second, name(s), s.object});
    return at->second;
  }
  std::vector<SimplexSoup::Group> take_groups() { return std::move(groups_); }

 private:
  std::string name(const PolygonSoup::Section& s) const {
    if (s.group.empty()) return s.object;
    return objects_of_.at(s.group).size() > 1 && !s.object.empty() ? s.object + "/" + s.group : s.group;
  }

  const PolygonSoup& soup_;
  std::map<std::string, std::set<std::string>> objects_of_;  // per group
  std::map<std::array<std::string, 2>, std::int32_t> tags_;
  std::vector<SimplexSoup::Group> groups_;
};

}  // namespace

SimplexSoup to_simplices(PolygonSoup polygons, const std::filesystem::path& path,
                         const ReadOptions& options) {
  SimplexBuilder builder(path.string(), SimplexBuilder::Where::element, 0);
  const TriangleSoup cut = triangulate(polygons);
  builder.keep_repeated();
  builder.reserve(2, cut.triangles.size());
  SectionTags tags(polygons);
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = static_cast<std::uint32_t>(cut.triangles[t][i].v);
    builder.add(2, corners, tags.tag(cut.polygon[t]), cut.polygon[t]);
    // The triangles of one polygon follow one another; its first one counts.
    const bool is_first = t == 0 || cut.polygon[t] != cut.polygon[t - 1];
    if (is_first && polygons.face(cut.polygon[t]).size() > 3) ++builder.notes().cut_polygons;
  }
  for (std::size_t l = 0; l < polygons.line_count(); ++l)
    for (std::uint32_t i = polygons.line_begin[l]; i + 1 < polygons.line_begin[l + 1]; ++i)
      builder.add(1,
                  std::array{static_cast<std::uint32_t>(polygons.line_corners[i]),
                             static_cast<std::uint32_t>(polygons.line_corners[i + 1])},
                  0, l);
  builder.notes().merged_points = polygons.notes.merged_positions;
  SimplexSoup& soup = builder.soup();
  soup.groups = tags.take_groups();
  soup.points = std::move(polygons.positions);
  soup.warnings = std::move(polygons.warnings);
  return builder.finish(options);
}

PolygonSoup to_polygons(const SimplexSoup& soup) {
  PolygonSoup polygons;
  polygons.positions = soup.points;
  for (const std::uint32_t v : soup.simplices[2].corners) {
    polygons.corners.push_back({static_cast<std::int32_t>(v), -1, -1});
    if (polygons.corners.size() % 3 == 0)
      polygons.face_begin.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  for (const std::uint32_t v : soup.simplices[1].corners) {
    polygons.line_corners.push_back(static_cast<std::int32_t>(v));
    if (polygons.line_corners.size() % 2 == 0)
      polygons.line_begin.push_back(static_cast<std::uint32_t>(polygons.line_corners.size()));
  }
  polygons.face_line.assign(polygons.face_count(), 0);
  polygons.sections.emplace_back();
  polygons.face_section.assign(polygons.face_count(), 0);
  return polygons;
}

namespace {

/// In the format of OBJ files for several groups: separated by blanks.
std::string group_names(const SimplexSoup& soup, std::int32_t tag) {
  std::string names;
  for (const std::int32_t group : groups_of(soup, 2, tag)) {
    const auto is_it = [&](const auto& g) { return g.dimension == 2 && g.tag == group; };
    const auto named = std::ranges::find_if(soup.groups, is_it);
    names += (names.empty() ? "" : " ") + (named != soup.groups.end() ? named->name : std::to_string(group));
  }
  return names;
}

}  // namespace

PolygonSoup to_grouped_polygons(const SimplexSoup& soup) {
  PolygonSoup polygons = to_polygons(soup);
  std::map<std::int32_t, std::uint32_t> section{{0, 0}};
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    const std::int32_t tag = soup.simplices[2].tags[f];
    const auto [at, is_new] = section.try_emplace(tag, static_cast<std::uint32_t>(polygons.sections.size()));
    if (is_new) polygons.sections.emplace_back().group = group_names(soup, tag);
    polygons.face_section[f] = at->second;
  }
  return polygons;
}

}  // namespace multimesh::io
