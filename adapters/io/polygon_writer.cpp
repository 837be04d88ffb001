// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/polygon_writer.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/output_buffer.hpp"
#include "adapters/io/polygons_to_simplices.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::io {
namespace {

void put_header(OutputBuffer& out, const PolygonSoup& soup, bool has_texcoords) {
  out.text("ply\nformat binary_little_endian 1.0\nelement vertex ");
  out.number(soup.positions.size());
  out.text("\nproperty double x\nproperty double y\nproperty double z\n");
  if (!soup.colors.empty()) out.text("property uchar red\nproperty uchar green\nproperty uchar blue\n");
  out.text("element face ");
  out.number(soup.face_count());
  out.text("\nproperty list uchar int vertex_indices\n");
  if (has_texcoords) out.text("property list uchar double texcoord\n");
  out.text("end_header\n");
}

void put_vertex(OutputBuffer& out, const PolygonSoup& soup, std::size_t v) {
  for (const double x : soup.positions[v]) out.little_endian(x);
  if (soup.colors.empty()) return;
  for (const double c : soup.colors[v])
    out.little_endian(static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.0, 1.0))));
}

/// A face without texture coordinates has an empty list of them.
void put_face(OutputBuffer& out, const PolygonSoup& soup, std::size_t f, bool has_texcoords) {
  const auto face = soup.face(f);
  out.little_endian(static_cast<std::uint8_t>(face.size()));
  for (const auto& c : face) out.little_endian(c.v);
  if (!has_texcoords) return;
  const bool has_all = std::ranges::all_of(face, [](const auto& c) { return c.vt >= 0; });
  out.little_endian(static_cast<std::uint8_t>(has_all ? 2 * face.size() : 0));
  for (std::size_t i = 0; has_all && i < face.size(); ++i)
    for (const double x : soup.texcoords[static_cast<std::size_t>(face[i].vt)]) out.little_endian(x);
}

void write_ply(const std::filesystem::path& path, const PolygonSoup& soup) {
  AtomicFile file(path);
  OutputBuffer out(file);
  const bool has_texcoords = !soup.texcoords.empty();
  put_header(out, soup, has_texcoords);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) put_vertex(out, soup, v);
  for (std::size_t f = 0; f < soup.face_count(); ++f) put_face(out, soup, f, has_texcoords);
  out.flush();
  file.commit();
}

SimplexSoup triangles_of(const PolygonSoup& soup) {
  SimplexSoup simplices;
  simplices.points = soup.positions;
  for (const auto& c : soup.corners)
    simplices.simplices[2].corners.push_back(static_cast<std::uint32_t>(c.v));
  simplices.simplices[2].tags.assign(soup.face_count(), 0);
  return simplices;
}

std::vector<std::string> left_out(const PolygonSoup& soup, const std::string& file, bool is_ply) {
  std::vector<std::string> sentences;
  const auto add = [&](bool is_there, const char* what) {
    if (is_there) sentences.push_back(file + ": " + what + " are not written; use .obj");
  };
  const auto any = [&](std::string PolygonSoup::Section::*name) {
    return std::ranges::any_of(soup.sections, [&](const auto& s) { return !(s.*name).empty(); });
  };
  add(!is_ply && !soup.texcoords.empty(), "texture coordinates");
  add(!is_ply && !soup.colors.empty(), "vertex colours");
  add(!soup.normals.empty(), "normals");
  add(any(&PolygonSoup::Section::material), "materials");
  add(any(&PolygonSoup::Section::group) || any(&PolygonSoup::Section::object), "groups and objects");
  return sentences;
}

}  // namespace

std::vector<std::string> write_polygons(const std::filesystem::path& path, const PolygonSoup& soup) {
  const bool is_ply = format_extension(path) == ".ply";
  if (is_ply)
    write_ply(path, soup);
  else
    write_simplices(path, triangles_of(soup));
  return left_out(soup, path.string(), is_ply);
}

}  // namespace multimesh::io
