// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/materials.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "adapters/io/material_library.hpp"
#include "adapters/io/mtl.hpp"
#include "adapters/io/mtl_rewrite.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::files {

namespace {

namespace fs = std::filesystem;

/// `Kd r g b` or `Kd r`; spectra and other colour spaces are ignored.
void read_color(io::TextCursor cursor, Material& material) {
  std::array<double, 3> rgb = {};
  if (!cursor.number(rgb[0])) return;
  if (!cursor.number(rgb[1]) || !cursor.number(rgb[2])) rgb[1] = rgb[2] = rgb[0];
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isnan(rgb[i])) material.color[i] = static_cast<float>(std::clamp(rgb[i], 0.0, 1.0));
}

class LibraryReader {
 public:
  LibraryReader(const fs::path& library, const fs::path& obj, bool follow_paths,
                std::vector<Material>& materials, std::vector<std::string>& notes)
      : library_(library),
        obj_(obj),
        finder_(library, obj, follow_paths),
        materials_(materials),
        notes_(notes) {}

  void read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    for (std::string& warning : finder_.warnings()) notes_.push_back(std::move(warning));
  }

 private:
  void line(std::string_view text) {
    io::TextCursor cursor(text);
    const std::string word = io::lower_case(cursor.word());
    if (word == "newmtl") {
      begin(std::string(io::trimmed(cursor.rest())));
    } else if (current_ == none) {
      return;
    } else if (word == "kd") {
      read_color(cursor, materials_[current_]);
    } else {
      // The function that rewrites textures knows where options end and the path begins.
      io::rewrite_textures(text, [&](std::string_view path) {
        const io::FoundFile found = finder_(path);
        if (word == "map_kd") set_texture(path, found);
        return std::string(path);
      });
    }
  }

  void set_texture(std::string_view name, const io::FoundFile& found) {
    if (found.outside) {
      notes_.push_back("the texture '" + std::string(name) + "' " + io::outside_of_directory(obj_));
    } else {
      materials_[current_].texture = found.path.empty() ? library_.parent_path() / name : found.path;
    }
  }

  void begin(std::string name) {
    const bool known = std::ranges::find(materials_, name, &Material::name) != materials_.end();
    current_ = known ? none : materials_.size();
    if (!known) materials_.push_back({.name = std::move(name)});
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  fs::path library_, obj_;
  io::TextureFinder finder_;
  std::vector<Material>& materials_;
  std::vector<std::string>& notes_;
  std::size_t current_ = none;
};

}  // namespace

std::vector<Material> read_materials(const std::vector<std::string>& libraries, const fs::path& obj,
                                     std::vector<std::string>& notes, bool follow_paths) {
  std::vector<Material> materials;
  for (const std::string& name : libraries) {
    const io::MaterialLibrary library = io::read_material_library(name, obj, follow_paths);
    if (!library.problem.empty())
      notes.push_back("the material library '" + name + "' " + library.problem +
                      (library.text.empty() ? "; its materials are grey" : ""));
    if (!library.text.empty())
      LibraryReader(library.path, obj, follow_paths, materials, notes).read(library.text);
  }
  return materials;
}

void read_materials(const std::string& mtl, const fs::path& file, std::vector<Material>& materials,
                    std::vector<std::string>& notes, bool follow_paths) {
  LibraryReader(file, file, follow_paths, materials, notes).read(mtl);
}

MaterialsInUse materials_in_use(const SurfaceFile& file, const std::vector<Index>& source) {
  MaterialsInUse in_use;
  std::vector<Material> known =
      read_materials(file.material_libraries, file.path, in_use.notes, file.follow_paths);
  read_materials(io::mtl_text(file.materials), file.path, known, in_use.notes, file.follow_paths);
  std::map<std::string, Index> number;
  for (const Index t : source) {
    const std::string& name = file.section_of(t).material;
    const auto [at, is_new] = number.try_emplace(name, static_cast<Index>(in_use.materials.size()));
    in_use.of_triangle.push_back(at->second);
    if (!is_new) continue;
    const auto found = std::ranges::find(known, name, &Material::name);
    in_use.materials.push_back(found != known.end() ? *found : Material{.name = name});
    if (found == known.end() && !name.empty() && !known.empty())
      in_use.notes.push_back("material " + name + ": not in the material libraries; it is grey");
  }
  return in_use;
}

}  // namespace multimesh::files
