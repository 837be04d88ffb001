// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/simplex_reader.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "adapters/io/content_check.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/medit_reader.hpp"
#include "adapters/io/mfem_reader.hpp"
#include "adapters/io/msh_reader.hpp"
#include "adapters/io/polygons_to_simplices.hpp"
#include "adapters/io/tetgen_files.hpp"
#include "adapters/io/vtk_reader.hpp"
#include "adapters/io/vtu_reader.hpp"
#include "multimesh/io/mesh_reader.hpp"

namespace multimesh::io {
namespace {

using Parser = SimplexSoup (*)(std::string_view, const std::filesystem::path&, const ReadOptions&);

struct Signature {
  std::string_view begin;
  Parser parse;
};

constexpr std::array<Signature, 6> signatures = {{{"$MeshFormat", parse_msh},
                                                  {"$NOD", parse_msh},
                                                  {"$Comments", parse_msh},
                                                  {"MeshVersionFormatted", parse_medit},
                                                  {"MFEM ", parse_mfem},
                                                  {"# vtk DataFile", parse_vtk}}};

/// Blanks, a byte order mark, and comments of MEDIT may come first.
std::string_view without_beginning(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with('#') || text.starts_with("# vtk DataFile")) return text;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

/// Nullptr when the content does not tell its format.
Parser parser_of(std::string_view bytes) {
  const std::string_view text = without_beginning(bytes.substr(0, 65536));
  for (const Signature& s : signatures)
    if (text.starts_with(s.begin)) return s.parse;
  const bool is_xml = text.starts_with("<");
  if (is_xml && text.substr(0, 4096).find("<VTKFile") != std::string_view::npos) return parse_vtu;
  return nullptr;
}

bool is_surface(std::string_view extension) {
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off";
}

/// Keeps everything of a file of polygons that a set of simplices can store.
ReadOptions all_of(ReadOptions options) {
  options.keep_lines = true;
  options.max_collapsed_share = 1;
  options.keep_repeated = true;  // solids that meet may both list their common faces
  return options;
}

[[noreturn]] void fail_unknown(std::string_view bytes, const std::string& file,
                               const std::string& extension) {
  refuse_foreign(bytes, file);
  if (extension == ".vtu" || extension == ".vtk")
    fail_file(file, "this is not a file of VTK; check the file or its extension");
  if (extension == ".msh")
    fail_file(file,
              "this is not a file of Gmsh: it does not begin with $MeshFormat (FreeFem and Fluent have "
              "other files of that name); convert it to .msh with Gmsh, or to .vtu");
  if (extension == ".mesh")
    fail_file(file, "this is neither a MEDIT file nor one of MFEM; convert it to a MEDIT file, .msh or .vtu");
  if (extension == ".meshb") fail_file(file, "binary MEDIT files are not read; convert it to .mesh");
  fail_file(file, (extension.empty() ? "the file has no extension"
                                     : "files with extension " + extension + " are not read") +
                      "; convert the mesh to .msh, .mesh or .vtu");
}

}  // namespace

SimplexSoup read_simplices(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string extension = format_extension(path);
  if (extension == ".node" || extension == ".ele") return read_tetgen_pair(path, options);
  if (is_surface(extension)) return to_simplices(read_mesh(path, all_of(options)), path, options);
  return parse_simplices(UnpackedBytes(path).view(), path, options);
}

SimplexSoup parse_simplices(std::string_view bytes, const std::filesystem::path& path,
                            const ReadOptions& options) {
  const std::string extension = format_extension(path);
  if (is_surface(extension)) return to_simplices(parse_mesh(bytes, path, all_of(options)), path, options);
  const Parser parse = parser_of(bytes);
  if (parse == nullptr) fail_unknown(bytes, path.string(), extension);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return parse(bytes, path, options);
}

}  // namespace multimesh::io
