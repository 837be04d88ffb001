// SPDX-License-Identifier: BSD-3-Clause
#include "tools/soup_of_files.hpp"

#include <filesystem>
#include <map>

#include "multimesh/error.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

std::string stem_of(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  return name.substr(0, name.find('.', 1));
}

/// What the file calls its triangles with a tag.
std::string name_of(const files::DomainFile& file, std::int32_t tag, bool has_others) {
  std::string name;
  const auto add_group = [&](std::int32_t t) {
    for (const auto& g : file.soup.groups)
      if (g.dimension == 2 && g.tag == t && !g.name.empty()) name += (name.empty() ? "" : "+") + g.name;
  };
  add_group(tag);
  if (name.empty())
    for (const auto& set : file.soup.tag_sets)
      if (set.dimension == 2 && set.tag == tag)
        for (const std::int32_t t : set.groups) add_group(t);
  if (!name.empty()) return name;
  return stem_of(file.path) + (has_others ? "_" + std::to_string(tag) : "");
}

void add_file(const std::string& path, SoupOfFiles& all) {
  files::DomainReadOptions options;
  options.no_weld = options.no_periodic = options.sides_stay = true;
  files::DomainFile file = files::read_domain(path, options);
  const auto& block = file.soup.simplices[2];
  if (block.size() == 0) throw InputError(path + ": has no triangle");
  TriangleSoup& soup = all.soup;
  const auto first = static_cast<Index>(soup.points.size());
  for (const auto& p : file.soup.points) soup.points.emplace_back(p);
  for (const Index v : block.corners) soup.triangles.corners.push_back(first + v);
  std::map<std::int32_t, std::int32_t> label;
  for (const std::int32_t tag : block.tags) label.emplace(tag, 0);
  for (auto& [tag, number] : label) {
    number = static_cast<std::int32_t>(all.patches.size() + 1);
    all.patches.push_back({2, number, name_of(file, tag, label.size() > 1)});
  }
  for (const std::int32_t tag : block.tags) soup.labels.push_back(label.at(tag));
  for (const std::size_t k : {0U, 1U, 3U})
    if (const std::size_t n = file.soup.simplices[k].size(); n > 0)
      file.warnings.push_back(path + ": " + std::to_string(n) +
                              (k == 0   ? " points are"
                               : k == 1 ? " edges are"
                                        : " tetrahedra are") +
                              " left out: only triangles are inserted");
  add(std::move(file.warnings), all.warnings);
}

}  // namespace

SoupOfFiles read_soup(const std::vector<std::string>& paths) {
  SoupOfFiles all;
  for (const std::string& path : paths) add_file(path, all);
  all.soup.triangles.vertices = static_cast<Index>(all.soup.points.size());
  return all;
}

}  // namespace multimesh::tools
