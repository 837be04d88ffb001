// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl.hpp"

#include <algorithm>
#include <system_error>

#include "adapters/io/atomic_file.hpp"
#include "adapters/io/file_bytes.hpp"
#include "adapters/io/mtl_rewrite.hpp"
#include "adapters/io/output_path.hpp"

namespace multimesh::io {
namespace {

namespace fs = std::filesystem;

fs::path directory_of(const fs::path& file) {
  return fs::weakly_canonical(fs::absolute(file).parent_path());
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// As written, or with the separators of Windows replaced if only that names a file.
fs::path with_slashes(std::string_view name, const fs::path& directory) {
  std::string slashes(name);
  std::ranges::replace(slashes, '\\', '/');
  return !is_file(directory / name) && is_file(directory / slashes) ? fs::path(slashes) : fs::path(name);
}

bool is_absolute(std::string_view name) {
  const bool drive = name.size() > 2 && name[1] == ':' && (name[2] == '\\' || name[2] == '/');
  return drive || name.starts_with('/') || name.starts_with("\\\\") ||
         name.find("://") != std::string_view::npos;
}

class Relocation {
 public:
  Relocation(const fs::path& input, const fs::path& output, std::vector<std::string>& warnings)
      : from_(directory_of(input)),
        to_(directory_of(checked_output_path(output))),
        stem_(output.stem().string()),
        output_(output.string()),
        warnings_(warnings) {}

  bool same_directory() const { return from_ == to_; }

  std::string relocate(const std::string& name) {
    const fs::path source = fs::weakly_canonical(from_ / with_slashes(name, from_));
    if (!is_file(source)) {
      warnings_.push_back(output_ + ": the material library '" + name + "' was not found in " +
                          from_.string() + "; its name is kept");
      return name;
    }
    if (source.parent_path() == to_) return source.filename().string();
    return copy(source);
  }

 private:
  std::string copy(const fs::path& source) {
    const FileBytes bytes(source);
    const fs::path directory = source.parent_path();
    const std::string text =
        rewrite_textures(bytes.view(), [&](std::string_view name) { return texture(name, directory); });
    const std::string name = free_name(source.filename().string(), text);
    if (!fs::exists(to_ / name)) {
      AtomicFile file(to_ / name);
      file.write(text);
      file.commit();
    }
    taken_.push_back(name);
    if (name != source.filename())
      warnings_.push_back(output_ + ": another " + source.filename().string() + " is in " + to_.string() +
                          "; the material library is written as " + name);
    return name;
  }

  /// Textures lie beside their MTL file, with some exporters beside the OBJ file.
  std::string texture(std::string_view name, const fs::path& mtl_directory) const {
    if (is_absolute(name)) return std::string(name);
    const fs::path beside_mtl = with_slashes(name, mtl_directory), beside_obj = with_slashes(name, from_);
    const bool use_obj = !is_file(mtl_directory / beside_mtl) && is_file(from_ / beside_obj);
    const fs::path target = use_obj ? from_ / beside_obj : mtl_directory / beside_mtl;
    const fs::path moved = target.lexically_normal().lexically_relative(to_);
    return moved.empty() ? target.string() : moved.generic_string();
  }

  /// The first name that is free, or that a file with this very content has.
  std::string free_name(const std::string& wanted, const std::string& text) const {
    if (is_usable(wanted, text)) return wanted;
    for (int n = 1;; ++n) {
      std::string name = stem_;
      if (n > 1) name.append("_").append(std::to_string(n));
      name.append(".mtl");
      if (is_usable(name, text)) return name;
    }
  }

  bool is_usable(const std::string& name, const std::string& text) const {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(to_ / name, error))) return true;
    return is_file(to_ / name) && std::ranges::find(taken_, name) == taken_.end() &&
           FileBytes(to_ / name).view() == text;
  }

  fs::path from_, to_;
  std::string stem_;
  std::string output_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> taken_;  ///< names that other libraries of this call were copied to
};

}  // namespace

std::vector<std::string> relocate_material_libraries(const std::vector<std::string>& libraries,
                                                     const fs::path& input, const fs::path& output,
                                                     std::vector<std::string>& warnings) {
  Relocation relocation(input, output, warnings);
  if (relocation.same_directory()) return libraries;
  std::vector<std::string> names;
  for (const std::string& library : libraries) names.push_back(relocation.relocate(library));
  return names;
}

}  // namespace multimesh::io
