// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/io/find_file.hpp"

namespace multimesh::io {

/// An MTL file that a mesh file names.
struct MaterialLibrary {
  std::filesystem::path path;  ///< empty: not found
  std::string text;            ///< its MTL statements; empty if there is a problem
  std::string problem;         ///< why it, or part of it, is not used; follows its name in a sentence
};

/// Reads it if find_file() finds it in or below the directory of `file`, or anywhere if paths are followed.
/// Only MTL is ever read into `text`, whatever the name of the file. Does not throw.
MaterialLibrary read_material_library(std::string_view name, const std::filesystem::path& file,
                                      bool follow_paths);

/// Why a file outside the directory of `file` is not used, to follow its name in a
/// sentence.
std::string outside_of_directory(const std::filesystem::path& file);

/// Finds the textures of a library: beside it, or else beside the mesh file. Records missing ones.
class TextureFinder {
 public:
  TextureFinder(const std::filesystem::path& library, const std::filesystem::path& file, bool follow_paths);

  /// As find_file().
  FoundFile operator()(std::string_view name);

  /// One sentence about all that were not found, or nothing.
  std::vector<std::string> warnings() const;

 private:
  FileSearch search_;
  std::string library_;
  std::vector<std::string> missing_;  ///< each once
};

}  // namespace multimesh::io
