// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl.hpp"

#include <algorithm>
#include <system_error>

#include "adapters/io/atomic_file.hpp"
#include "adapters/io/file_bytes.hpp"
#include "adapters/io/find_file.hpp"
#include "adapters/io/material_library.hpp"
#include "adapters/io/mtl_rewrite.hpp"
#include "adapters/io/output_path.hpp"

namespace multimesh::io {
namespace {

namespace fs = std::filesystem;

class Relocation {
 public:
  Relocation(const fs::path& input, const fs::path& output, bool follow_paths,
             std::vector<std::string>& warnings)
      : input_(input),
        follow_paths_(follow_paths),
        from_(directory_of(input)),
        to_(directory_of(checked_output_path(output))),
        stem_(output.stem().string()),
        output_(output.string()),
        warnings_(warnings) {}

  bool same_directory() const { return from_ == to_; }

  std::string relocate(const std::string& name) {
    const MaterialLibrary library = read_material_library(name, input_, follow_paths_);
    if (is_in_place(library.path)) return library.path.filename().string();
    if (!library.problem.empty())
      warnings_.push_back(output_ + ": the material library '" + name + "' " + library.problem +
                          (library.text.empty() ? "; its name is kept" : ""));
    return library.text.empty() ? name : copy(library);
  }

  /// Writes a library of the input next to the output, unless it is already there.
  std::string copy(const MaterialLibrary& library) {
    TextureFinder finder(library.path, input_, follow_paths_);
    const fs::path directory = directory_of(library.path);
    const std::string text = rewrite_textures(
        library.text, [&](std::string_view name) { return texture(name, directory, finder(name).path); });
    for (std::string& warning : finder.warnings()) warnings_.push_back(std::move(warning));
    const std::string source = library.path.filename().string(), name = free_name(source, text);
    if (!fs::exists(to_ / name)) {
      AtomicFile file(to_ / name);
      file.write(text);
      file.commit();
    }
    taken_.push_back(name);
    if (name != source)
      warnings_.push_back(output_ + ": another " + source + " is in " + to_.string() +
                          "; the material library is written as " + name);
    return name;
  }

 private:
  bool is_in_place(const fs::path& library) const { return !library.empty() && directory_of(library) == to_; }

  /// The name of a texture relative to the output. The file that was found may have another name: for
  /// instance one of the tiles that `<UDIM>` stands for.
  std::string texture(std::string_view name, const fs::path& mtl_directory, const fs::path& found) const {
    if (is_absolute_name(name) && (found.empty() || found == fs::path(name))) return std::string(name);
    std::string last(last_part(name));
    if (last.find('<') == std::string::npos && !found.empty()) last = found.filename().string();
    const fs::path target = found.empty() ? mtl_directory / name : directory_of(found) / last;
    const fs::path moved = target.lexically_normal().lexically_relative(to_);
    return moved.empty() ? target.string() : moved.generic_string();
  }

  /// The first name that is free, or whose file has this same content.
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

  fs::path input_;
  bool follow_paths_;
  fs::path from_, to_;
  std::string stem_;
  std::string output_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> taken_;  ///< names that other libraries of this call were copied to
};

}  // namespace

std::vector<std::string> relocate_material_libraries(const std::vector<std::string>& libraries,
                                                     const fs::path& input, const fs::path& output,
                                                     std::vector<std::string>& warnings, bool follow_paths) {
  Relocation relocation(input, output, follow_paths, warnings);
  if (relocation.same_directory()) return libraries;
  std::vector<std::string> names;
  for (const std::string& library : libraries) names.push_back(relocation.relocate(library));
  return names;
}

std::string mtl_text(const std::vector<PolygonSoup::Material>& materials) {
  std::string text;
  for (const PolygonSoup::Material& m : materials) {
    text += "newmtl " + m.name + "\nKd 1 1 1\n";
    if (!m.texture.empty()) text += "map_Kd " + m.texture + "\n";
  }
  return text;
}

std::string write_material_library(const std::vector<PolygonSoup::Material>& materials, const fs::path& input,
                                   const fs::path& output, std::vector<std::string>& warnings) {
  fs::path name = output.filename();
  name.replace_extension(".mtl");
  return Relocation(input, output, true, warnings)
      .copy({input.parent_path() / name, mtl_text(materials), {}});
}

}  // namespace multimesh::io
