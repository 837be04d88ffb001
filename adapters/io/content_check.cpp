// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/content_check.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "adapters/io/input_location.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

constexpr std::size_t looked_at = 4096;

struct Signature {
  std::string_view begin;
  std::string_view message;
};

using namespace std::string_view_literals;

constexpr std::array exact_signatures = {
    Signature{"\xFF\xFE"sv, "this is UTF-16 text; save the mesh as plain ASCII or UTF-8 text"},
    Signature{"\xFE\xFF"sv, "this is UTF-16 text; save the mesh as plain ASCII or UTF-8 text"},
    Signature{"\0\0\xFE\xFF"sv, "this is UTF-32 text; save the mesh as plain ASCII or UTF-8 text"},
    Signature{"\x1F\x8B"sv, "this file is compressed (gzip); unpack it first"},
    Signature{"\xFD\x37zXZ"sv, "this file is compressed (xz); unpack it first"},
    Signature{"\x28\xB5\x2F\xFD"sv, "this file is compressed (zstd); unpack it first"},
    Signature{"BZh"sv, "this file is compressed (bzip2); unpack it first"},
    Signature{"PK\x03\x04"sv, "this is a ZIP archive; unpack it first"},
    Signature{"glTF"sv, "this is a binary glTF file; convert it to OBJ or PLY"}};

constexpr std::array text_signatures = {
    Signature{"version https://git-lfs"sv,
              "this is a Git LFS pointer, not the mesh itself; fetch the mesh with 'git lfs pull'"},
    Signature{"<!doctype html"sv, "this is a web page, not a mesh; download the raw file"},
    Signature{"<html"sv, "this is a web page, not a mesh; download the raw file"},
    Signature{"<"sv, "this is an XML or HTML file, not a mesh that we read; convert it to OBJ or PLY"}};

constexpr std::array other_meshes = {
    Signature{"ply\n"sv, "this is a PLY file; give it the extension .ply"},
    Signature{"ply\r"sv, "this is a PLY file; give it the extension .ply"},
    Signature{"solid "sv, "this is an STL file; give it the extension .stl"},
    Signature{"off\n"sv, "this is an OFF file; give it the extension .off"},
    Signature{"$meshformat"sv, "this is a Gmsh file; give it the extension .msh"},
    Signature{"# vtk datafile"sv, "this is a VTK file; give it the extension .vtk"}};

bool begins_with(std::string_view text, std::string_view begin) {
  return text.size() >= begin.size() && std::equal(begin.begin(), begin.end(), text.begin(),
                                                   [](char a, char b) { return a == lower_case(b); });
}

std::string_view without_leading_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

}  // namespace

void refuse_foreign(std::string_view bytes, std::string_view file) {
  if (bytes.empty()) fail_file(file, "the file is empty; export the mesh again");
  for (const Signature& s : exact_signatures)
    if (bytes.starts_with(s.begin)) fail_file(file, s.message);
  const std::string_view text = without_leading_blanks(bytes.substr(0, looked_at));
  for (const Signature& s : text_signatures)
    if (begins_with(text, s.begin)) fail_file(file, s.message);
}

void check_obj_content(std::string_view bytes, std::string_view file) {
  refuse_foreign(bytes, file);
  const std::string_view text = without_leading_blanks(bytes.substr(0, looked_at));
  for (const Signature& s : other_meshes)
    if (begins_with(text, s.begin)) fail_file(file, s.message);
  if (bytes.substr(0, looked_at).find('\0') != std::string_view::npos)
    fail_file(file, "this is a binary file, not a Wavefront OBJ; export the mesh as OBJ or PLY");
}

void check_ply_content(std::string_view bytes, std::string_view file) {
  refuse_foreign(bytes, file);
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return;
  fail_file(file,
            "this is not a PLY file: it does not begin with a line 'ply'; check the file or its extension");
}

}  // namespace multimesh::io
