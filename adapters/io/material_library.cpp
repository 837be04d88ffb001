// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/material_library.hpp"

#include <algorithm>

#include "adapters/io/file_bytes.hpp"
#include "adapters/io/mtl_statements.hpp"
#include "multimesh/error.hpp"

namespace multimesh::io {

namespace fs = std::filesystem;

std::string outside_of_directory(const fs::path& file) {
  return "lies outside of the directory of " + file.filename().string() +
         " and is not read; --follow-paths reads such files";
}

MaterialLibrary read_material_library(std::string_view name, const fs::path& file, bool follow_paths) {
  const FoundFile found = find_file(name, search_beside(file, follow_paths));
  MaterialLibrary library{found.path, {}, {}};
  if (found.path.empty()) {
    library.problem = "was not found in " + directory_of(file).string();
    return library;
  }
  if (found.outside) {
    library.problem = outside_of_directory(file);
    return library;
  }
  try {
    MtlText mtl = read_mtl(FileBytes(found.path).view());
    if (!mtl.is_mtl()) {
      library.problem = "is no MTL file, and not used";
      return library;
    }
    library.text = std::move(mtl.text);
    if (mtl.left_out > 0)
      library.problem = "has " + std::to_string(mtl.left_out) + " lines that are no MTL; they are left out";
  } catch (const InputError&) {
    library.problem = "cannot be read";
  }
  return library;
}

TextureFinder::TextureFinder(const fs::path& library, const fs::path& file, bool follow_paths)
    : search_(search_beside(file, follow_paths)), library_(library.filename().string()) {
  search_.directories.insert(search_.directories.begin(), library.parent_path());
}

FoundFile TextureFinder::operator()(std::string_view name) {
  FoundFile found = find_file(name, search_);
  if (found.path.empty() && std::ranges::find(missing_, name) == missing_.end()) missing_.emplace_back(name);
  return found;
}

std::vector<std::string> TextureFinder::warnings() const {
  if (missing_.empty()) return {};
  constexpr std::size_t most = 3;
  std::string text = "textures of the material library " + library_ + " were not found:";
  for (std::size_t i = 0; i < std::min(most, missing_.size()); ++i)
    text += (i == 0 ? " '" : ", '") + missing_[i] + "'";
  if (missing_.size() > most) text += " and " + std::to_string(missing_.size() - most) + " more";
  return {text};
}

}  // namespace multimesh::io
