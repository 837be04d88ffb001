// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/region_names.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

namespace multimesh::tetgen {

namespace {

using Names = std::set<std::string>;

/// A facet seen from one of its regions.
struct Border {
  Index facet, beyond;
};

class RegionNames {
 public:
  RegionNames(const Tetrahedralization& mesh, const TriangleNames& names)
      : names_(mesh.names), borders_(mesh.names.size()), labels_(mesh.facets.size()) {
    for (Index f = 0; f < labels_.size(); ++f)
      for (const FacetSource& source : mesh.facets.sources_of(f)) {
        const auto part = names.parts.find(names.tags[source.triangle]);
        if (part == names.parts.end()) continue;
        for (const std::string& name : {part->second.name, part->second.object})
          if (!name.empty() && labels_[f].insert(name).second) ++sizes_[name];
      }
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const auto [behind, before] = mesh.faces[i].regions;
      const Index f = mesh.faces[i].facet;
      if (behind == before || (i > 0 && mesh.faces[i - 1].facet == f)) continue;
      if (behind != no_index) borders_[behind].push_back({f, before});
      if (before != no_index) borders_[before].push_back({f, behind});
    }
  }

  std::vector<std::string> find() {
    by_enclosure();
    by_belonging();
    by_enclosure();
    return std::move(names_);
  }

 private:
  /// A name is found more easily when the neighbours have theirs: until nothing changes.
  void by_enclosure() {
    for (bool grows = true; grows;) {
      grows = false;
      for (Index r = 0; r < names_.size(); ++r)
        if (names_[r].empty()) grows |= !(names_[r] = enclosing(r)).empty();
    }
  }

  /// The name that all facets around a region have, but for those that have only the name of the region
  /// beyond. Of several, one that no neighbour has; of these, that of the
  /// smallest part.
  std::string enclosing(Index r) const {
    std::optional<Names> common;
    Names neighbours;
    for (const Border& b : borders_[r]) {
      const std::string& beyond = b.beyond == no_index ? std::string() : names_[b.beyond];
      if (!beyond.empty()) neighbours.insert(beyond);
      if (labels_[b.facet].size() == 1 && labels_[b.facet].contains(beyond)) continue;
      if (!common) common = labels_[b.facet];
      std::erase_if(*common, [&](const std::string& name) { return !labels_[b.facet].contains(name); });
    }
    if (!common) return {};
    const auto least = std::min_element(common->begin(), common->end(), [&](const auto& a, const auto& b) {
      return std::pair(neighbours.contains(a), sizes_.at(a)) <
             std::pair(neighbours.contains(b), sizes_.at(b));
    });
    return least == common->end() ? std::string() : *least;
  }

  /// Where each interface is listed once, for either side: a name whose facets are all at one region belongs
  /// to it. A region has the name if it is the only one, and all facets around belong to it or its neighbour.
  void by_belonging() {
    std::map<std::string, std::set<Index>> regions_of;
    for (const auto& [name, size] : sizes_) regions_of[name] = regions_at(name);
    const auto belongs = [&](const std::string& name, Index r) {
      const auto& regions = regions_of.at(name);
      return regions.size() == 1 && *regions.begin() == r;
    };
    std::vector<std::string> found(names_.size());
    for (Index r = 0; r < names_.size(); ++r) {
      Names own;
      bool all = names_[r].empty();
      for (const Border& b : borders_[r]) {
        bool any = false;
        for (const std::string& name : labels_[b.facet]) {
          if (belongs(name, r)) own.insert(name);
          any |= belongs(name, r) || (b.beyond != no_index && belongs(name, b.beyond));
        }
        all &= any;
      }
      if (all && own.size() == 1) found[r] = *own.begin();
    }
    for (Index r = 0; r < names_.size(); ++r)
      if (!found[r].empty()) names_[r] = found[r];
  }

  /// The regions that all facets with a name are at.
  std::set<Index> regions_at(const std::string& name) {
    if (facets_of_.empty())
      for (Index r = 0; r < borders_.size(); ++r)
        for (const Border& b : borders_[r])
          for (const std::string& label : labels_[b.facet]) ++facets_of_[label][r];
    std::set<Index> regions;
    for (const auto& [r, count] : facets_of_[name])
      if (count == sizes_.at(name)) regions.insert(r);
    return regions;
  }

  std::vector<std::string> names_;                                 // per region
  std::vector<std::vector<Border>> borders_;                       // per region
  std::vector<Names> labels_;                                      // per facet
  std::map<std::string, std::size_t> sizes_;                       // facets per name
  std::map<std::string, std::map<Index, std::size_t>> facets_of_;  // per name and region
};

}  // namespace

std::vector<std::string> region_names(const Tetrahedralization& mesh, const TriangleNames& names) {
  return names.parts.empty() || !names.name_regions ? mesh.names : RegionNames(mesh, names).find();
}

}  // namespace multimesh::tetgen
