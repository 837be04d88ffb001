// SPDX-License-Identifier: BSD-3-Clause
#include "tools/mtl_materials.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "adapters/io/file_bytes.hpp"
#include "adapters/io/mtl_rewrite.hpp"
#include "adapters/io/text_cursor.hpp"
#include "multimesh/error.hpp"

namespace multimesh::tools {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The first of these that exists: as written or with slashes, in each of the directories in turn.
fs::path resolved(std::string_view name, std::initializer_list<fs::path> directories) {
  std::string slashes(name);
  std::ranges::replace(slashes, '\\', '/');
  for (const fs::path& directory : directories)
    for (const std::string& written : {std::string(name), slashes})
      if (is_file(directory / written)) return directory / written;
  return *directories.begin() / std::string(name);
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// `Kd r g b` or `Kd r`; spectra and other colour spaces are left alone.
void read_color(io::TextCursor cursor, Material& material) {
  std::array<double, 3> rgb = {};
  if (!cursor.number(rgb[0])) return;
  if (!cursor.number(rgb[1]) || !cursor.number(rgb[2])) rgb[1] = rgb[2] = rgb[0];
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isnan(rgb[i])) material.color[i] = static_cast<float>(std::clamp(rgb[i], 0.0, 1.0));
}

class LibraryReader {
 public:
  LibraryReader(const fs::path& library, const fs::path& obj, std::vector<Material>& materials)
      : beside_library_(library.parent_path()), beside_obj_(obj.parent_path()), materials_(materials) {}

  void read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
  }

 private:
  void line(std::string_view text) {
    io::TextCursor cursor(text);
    const std::string word = lower(cursor.word());
    if (word == "newmtl") {
      begin(std::string(io::trimmed(cursor.rest())));
    } else if (current_ == none) {
      return;
    } else if (word == "kd") {
      read_color(cursor, materials_[current_]);
    } else if (word == "map_kd") {
      // The function that rewrites textures knows where options end and the path begins.
      io::rewrite_textures(text, [&](std::string_view path) {
        materials_[current_].texture = resolved(path, {beside_library_, beside_obj_});
        return std::string(path);
      });
    }
  }

  void begin(std::string name) {
    const bool known = std::ranges::find(materials_, name, &Material::name) != materials_.end();
    current_ = known ? none : materials_.size();
    if (!known) materials_.push_back({.name = std::move(name)});
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  fs::path beside_library_, beside_obj_;
  std::vector<Material>& materials_;
  std::size_t current_ = none;
};

}  // namespace

std::vector<Material> read_materials(const std::vector<std::string>& libraries, const fs::path& obj,
                                     std::vector<std::string>& notes) {
  std::vector<Material> materials;
  for (const std::string& name : libraries) {
    const fs::path library = resolved(name, {obj.parent_path()});
    try {
      const io::FileBytes bytes(library);
      LibraryReader(library, obj, materials).read(bytes.view());
    } catch (const InputError&) {
      notes.push_back("material library " + name + ": not found, or not readable; its materials are grey");
    }
  }
  return materials;
}

}  // namespace multimesh::tools
