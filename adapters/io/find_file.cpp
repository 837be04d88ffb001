// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/find_file.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

namespace fs = std::filesystem;

std::string with_slashes(std::string_view name) {
  std::string slashes(name);
  std::ranges::replace(slashes, '\\', '/');
  return slashes;
}

bool is_below(const fs::path& path, const fs::path& directory) {
  const auto [at, unused] = std::mismatch(directory.begin(), directory.end(), path.begin(), path.end());
  return at == directory.end() || (at->empty() && std::next(at) == directory.end());
}

bool is_inside(const fs::path& path, const FileSearch& search) {
  if (search.inside.empty()) return true;
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return !error && is_below(canonical, fs::weakly_canonical(search.inside, error));
}

/// Whether a pattern, in which <UDIM> stands for four digits, is this name except for the case of letters.
bool matches(std::string_view pattern, std::string_view name) {
  constexpr std::string_view tile = "<udim>";
  while (!pattern.empty()) {
    if (lower_case(pattern.substr(0, tile.size())) == tile) {
      if (name.size() < 4 || !std::all_of(name.begin(), name.begin() + 4, is_digit)) return false;
      pattern.remove_prefix(tile.size());
      name.remove_prefix(4);
      continue;
    }
    if (name.empty() || lower_case(pattern.front()) != lower_case(name.front())) return false;
    pattern.remove_prefix(1);
    name.remove_prefix(1);
  }
  return name.empty();
}

/// The entry of a directory that `part` denotes; the first one of several. Empty: none.
fs::path entry(const fs::path& directory, const fs::path& part) {
  std::error_code error;
  if (fs::exists(directory / part, error)) return directory / part;
  std::string best;
  for (fs::directory_iterator at(directory, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (matches(part.string(), name) && (best.empty() || name < best)) best = name;
  }
  return best.empty() ? fs::path() : directory / best;
}

/// Follows a path part by part. Empty: there is no such file.
fs::path resembling(const fs::path& directory, const std::string& name) {
  fs::path at = directory;
  for (const fs::path& part : fs::path(name)) {
    if (part.is_absolute()) {
      at = part;
    } else if (at = entry(at.empty() ? fs::path(".") : at, part); at.empty()) {
      return {};
    }
  }
  return is_file(at) ? at : fs::path();
}

/// Keeps the first file that is inside, or else the first one.
class Best {
 public:
  explicit Best(const FileSearch& search) : search_(search) {}

  /// \return whether the search is over.
  bool add(const fs::path& path) {
    if (path.empty() || !is_file(path)) return false;
    const bool inside = is_inside(path, search_);
    if (inside || found_.path.empty()) found_ = {path, !inside};
    return inside;
  }
  const FoundFile& found() const { return found_; }

 private:
  const FileSearch& search_;
  FoundFile found_;
};

}  // namespace

FoundFile find_file(std::string_view name, const FileSearch& search) {
  Best best(search);
  const std::string slashes = with_slashes(name), last(last_part(name));
  for (const std::string& written : {std::string(name), slashes})
    for (const fs::path& directory : search.directories)
      if (best.add(directory / written)) return best.found();
  for (const std::string& written : {slashes, last})
    for (const fs::path& directory : search.directories)
      if (best.add(resembling(directory, written))) return best.found();
  return best.found();
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_absolute_name(std::string_view name) {
  const bool drive = name.size() > 2 && name[1] == ':' && (name[2] == '\\' || name[2] == '/');
  return drive || name.starts_with('/') || name.starts_with("\\\\") ||
         name.find("://") != std::string_view::npos;
}

std::string_view last_part(std::string_view name) {
  return name.substr(name.find_last_of("/\\") + 1);
}

fs::path directory_of(const fs::path& file) {
  std::error_code error;
  const fs::path parent = fs::absolute(file, error).parent_path();
  const fs::path canonical = fs::weakly_canonical(parent, error);
  return error ? parent : canonical;
}

FileSearch search_beside(const fs::path& file, bool anywhere) {
  return {{file.parent_path()}, anywhere ? fs::path() : directory_of(file)};
}

}  // namespace multimesh::io
