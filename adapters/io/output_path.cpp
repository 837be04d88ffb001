// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/output_path.hpp"

#include <system_error>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {

namespace fs = std::filesystem;

fs::path checked_output_path(const fs::path& path) {
  std::error_code error;
  const std::string name = path.string();
  if (fs::is_directory(path, error)) fail_file(name, "the output is a directory; give the path of a file");
  if (!path.has_filename()) fail_file(name, "the output path names no file; give the path of a file");
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    fail_file(name, "the output is not a regular file; give the path of a file");
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (target.empty()) fail_file(name, "the link cannot be followed: " + error.message());
  const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::exists(directory, error))
    fail_file(name, "the directory " + directory.string() + " does not exist; create it first");
  if (!fs::is_directory(directory, error))
    fail_file(name, directory.string() + " is not a directory; correct the output path");
  return target;
}

}  // namespace multimesh::io
