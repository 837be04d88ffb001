// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/naming.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "adapters/tetgen/region_names.hpp"

namespace multimesh::tetgen {

namespace {

using Tag = std::int32_t;

/// A positive number that makes up the whole text; 0: anything else.
Tag number_in(const std::string& text) {
  Tag n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  return error == std::errc() && end == text.data() + text.size() && n > 0 ? n : 0;
}

std::vector<Naming::Tag> tag_regions(const Tetrahedralization& mesh, const TriangleNames& names) {
  const std::vector<std::string> found = region_names(mesh, names);
  std::vector<Naming::Tag> regions(found.size());
  std::set<Tag> used;
  for (std::size_t r = 0; r < found.size(); ++r)
    if ((regions[r].tag = number_in(mesh.names[r])) > 0) used.insert(regions[r].tag);
  Tag next = 1;
  std::map<std::string, Tag> by_seed;
  std::map<std::string, int> repeated;
  for (std::size_t r = 0; r < found.size(); ++r) {
    Naming::Tag& own = regions[r];
    if (own.tag > 0) continue;
    own.name = found[r];
    const bool has_seed = !mesh.names[r].empty();
    if (has_seed && by_seed.contains(own.name)) {
      own.tag = by_seed[own.name];  // several seeds of one name make one region
      continue;
    }
    while (used.contains(next)) ++next;
    own.tag = next++;
    if (has_seed) by_seed[own.name] = own.tag;
    if (const int n = own.name.empty() ? 1 : ++repeated[own.name]; n > 1) own.name += "." + std::to_string(n);
  }
  return regions;
}

/// What the faces of one patch have in common.
struct Kind {
  bool is_inside = false;  ///< no side is outside; first, those that are not
  std::vector<Tag> tags;   ///< of the input, ascending
  std::array<Index, 2> regions{};
  friend auto operator<=>(const Kind&, const Kind&) = default;
};

Kind kind_of(const Tetrahedralization& mesh, const TriangleNames& names, const SurfaceFace& face) {
  Kind kind;
  for (const FacetSource& source : mesh.facets.sources_of(face.facet))
    kind.tags.push_back(names.tags[source.triangle]);
  std::sort(kind.tags.begin(), kind.tags.end());
  kind.tags.erase(std::unique(kind.tags.begin(), kind.tags.end()), kind.tags.end());
  kind.regions = {std::min(face.regions.behind, face.regions.before),
                  std::max(face.regions.behind, face.regions.before)};
  kind.is_inside = kind.regions[1] != no_index;
  return kind;
}

class Patches {
 public:
  Patches(const TriangleNames& names, const std::vector<Naming::Tag>& regions)
      : names_(names), regions_(regions) {}

  void name(const std::set<Kind>& kinds, Naming& out) {
    std::map<std::vector<Tag>, int> kinds_of;
    for (const Kind& kind : kinds) ++kinds_of[kind.tags];
    Tag next = 1;
    for (const Tag t : names_.tags) next = std::max(next, t + 1);
    warn_of_parts(kinds_of, out.warnings);
    for (const Kind& kind : kinds) {
      std::string text = base_name(kind.tags);
      if (!text.empty() && kinds_of[kind.tags] > 1)
        text += ":" + region(kind.regions[0]) + "|" + region(kind.regions[1]);
      const bool keeps_tag = kind.tags.size() == 1 && kind.tags[0] > 0 && kinds_of[kind.tags] == 1;
      const Tag tag = keeps_tag ? kind.tags[0] : next++;
      out.patches.push_back({tag, text});
      tag_of_[kind] = tag;
    }
    std::sort(out.patches.begin(), out.patches.end(),
              [](const Naming::Tag& a, const Naming::Tag& b) { return a.tag < b.tag; });
  }
  Tag tag(const Kind& kind) const { return tag_of_.at(kind); }

 private:
  void warn_of_parts(const std::map<std::vector<Tag>, int>& kinds_of,
                     std::vector<std::string>& warnings) const {
    int parts = 0, patches = 0;
    std::string first;
    for (const auto& [tags, count] : kinds_of) {
      const std::string name = base_name(tags);
      if (count == 1 || name.empty()) continue;
      if (parts++ == 0) first = name;
      patches += count;
    }
    if (parts == 1)
      warnings.push_back("the part " + first + " of the surface lies between several pairs of regions: " +
                         std::to_string(patches) + " patches are made of it");
    if (parts > 1)
      warnings.push_back(std::to_string(parts) + " parts of the surface, " + first +
                         " among them, lie between several pairs of regions each: " +
                         std::to_string(patches) + " patches are made of them");
  }

  std::string base_name(const std::vector<Tag>& tags) const {
    std::string text;
    for (const Tag t : tags) {
      const auto part = names_.parts.find(t);
      if (part == names_.parts.end() || part->second.name.empty()) continue;
      text += (text.empty() ? "" : "+") + part->second.name;
    }
    return text;
  }
  std::string region(Index r) const {
    if (r == no_index) return "outside";
    return regions_[r].name.empty() ? std::to_string(regions_[r].tag) : regions_[r].name;
  }

  const TriangleNames& names_;
  const std::vector<Naming::Tag>& regions_;
  std::map<Kind, Tag> tag_of_;
};

}  // namespace

Naming name_parts(const Tetrahedralization& mesh, const TriangleNames& names) {
  Naming out;
  out.regions = tag_regions(mesh, names);
  std::vector<Kind> kinds;
  for (const SurfaceFace& face : mesh.faces) kinds.push_back(kind_of(mesh, names, face));
  Patches patches(names, out.regions);
  patches.name({kinds.begin(), kinds.end()}, out);
  for (const Kind& kind : kinds) out.face_tags.push_back(patches.tag(kind));
  return out;
}

}  // namespace multimesh::tetgen
