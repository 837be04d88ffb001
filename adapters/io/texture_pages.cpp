// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/texture_pages.hpp"

#include <algorithm>

#include "adapters/io/find_file.hpp"

namespace multimesh::io {

TexturePages::TexturePages(const std::vector<std::string>& images) : images_(images) {}

std::uint32_t TexturePages::section(std::int64_t page, PolygonSoup& soup) {
  page = std::max<std::int64_t>(page, -1);
  const auto known = std::ranges::find(pages_, page);
  if (known != pages_.end()) return static_cast<std::uint32_t>(known - pages_.begin());
  PolygonSoup::Section& section = soup.sections.emplace_back();
  pages_.push_back(page);
  names_.emplace_back();
  if (page >= 0) {
    const bool has_image = static_cast<std::size_t>(page) < images_.size();
    const std::string image = has_image ? images_[static_cast<std::size_t>(page)] : std::string();
    names_.back() = section.material = unique_name(has_image ? image : "page_" + std::to_string(page));
    soup.materials.push_back({section.material, image});
  }
  return static_cast<std::uint32_t>(pages_.size() - 1);
}

/// The name of the image without its directory, its extension and characters that end a name for some
/// readers.
std::string TexturePages::unique_name(const std::string& image) const {
  std::string name(last_part(image));
  if (const std::size_t dot = name.rfind('.'); dot != std::string::npos && dot > 0) name.resize(dot);
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == '#') c = '_';
  const auto taken = [&](const std::string& n) {
    return n.empty() || std::ranges::find(names_, n) != names_.end();
  };
  if (!taken(name)) return name;
  for (int n = 2;; ++n)
    if (std::string next = name + "_" + std::to_string(n); !taken(next)) return next;
}

}  // namespace multimesh::io
