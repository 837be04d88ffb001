// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace multimesh::io {

/// Where to search for a file that another file names.
struct FileSearch {
  std::vector<std::filesystem::path> directories;  ///< in this order; names are relative to them
  /// Files outside this directory are reported, but must not be read. Empty: all may be. Links count as their
  /// targets.
  std::filesystem::path inside = {};
};

struct FoundFile {
  std::filesystem::path path = {};  ///< empty: not found
  bool outside = false;             ///< it exists, but outside FileSearch::inside
};

/// The regular file that `name` denotes, written on this or another machine: as written; with `\` for `/`;
/// with letters of another case; with `<UDIM>` for four digits, the least ones. If none of these exists or is
/// inside, its last part beside the other file, as for absolute paths of another machine.
FoundFile find_file(std::string_view name, const FileSearch& search);

/// Whether there is a regular file; without the reason if not.
bool is_file(const std::filesystem::path& path);

/// `/x`, `C:\x`, `\\server\x`, `file://x`.
bool is_absolute_name(std::string_view name);

/// The part after the last separator of either kind.
std::string_view last_part(std::string_view name);

/// The directory that contains a file, absolute and without links.
std::filesystem::path directory_of(const std::filesystem::path& file);

/// The search for files that `file` names. `anywhere`: not only in and below its own directory.
FileSearch search_beside(const std::filesystem::path& file, bool anywhere);

}  // namespace multimesh::io
