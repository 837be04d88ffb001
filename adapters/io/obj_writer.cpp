// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/obj_writer.hpp"

#include <array>
#include <string_view>

#include "adapters/io/atomic_file.hpp"
#include "adapters/io/output_buffer.hpp"

namespace multimesh::io {
namespace {

template <std::size_t N>
void put(OutputBuffer& out, const std::array<double, N>& numbers) {
  for (const double n : numbers) {
    out.character(' ');
    out.number(n);
  }
}

template <std::size_t N>
void put_lines(OutputBuffer& out, std::string_view word, const std::vector<std::array<double, N>>& lines) {
  for (const auto& numbers : lines) {
    out.text(word);
    put(out, numbers);
    out.character('\n');
  }
}

void put_positions(OutputBuffer& out, const PolygonSoup& soup) {
  if (soup.colors.empty()) return put_lines(out, "v", soup.positions);
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    out.character('v');
    put(out, soup.positions[i]);
    put(out, soup.colors[i]);
    out.character('\n');
  }
}

void put_corner(OutputBuffer& out, const PolygonSoup::Corner& c, bool normals) {
  out.character(' ');
  out.number(c.v + 1);
  const bool has_normal = normals && c.vn >= 0;
  if (c.vt < 0 && !has_normal) return;
  out.character('/');
  if (c.vt >= 0) out.number(c.vt + 1);
  if (!has_normal) return;
  out.character('/');
  out.number(c.vn + 1);
}

void put_line(OutputBuffer& out, std::string_view word, std::string_view rest) {
  out.text(word);
  out.text(rest);
  out.text("\n");
}

/// The statement when the value changed; `off` stands for an empty value, nothing when `off` is empty.
void put_change(OutputBuffer& out, std::string_view word, const std::string& before, const std::string& now,
                std::string_view off = {}) {
  if (before == now) return;
  const std::string_view name = now.empty() ? off : std::string_view(now);
  out.text(word);
  if (!name.empty()) out.text(" ");
  out.text(name);
  out.text("\n");
}

void put_section(OutputBuffer& out, const PolygonSoup::Section& before, const PolygonSoup::Section& now) {
  put_change(out, "o", before.object, now.object);
  put_change(out, "g", before.group, now.group);
  put_change(out, "usemtl", before.material, now.material);
  put_change(out, "s", before.smoothing, now.smoothing, "off");
}

void put_faces(OutputBuffer& out, const PolygonSoup& soup, bool normals) {
  const PolygonSoup::Section none;
  const PolygonSoup::Section* current = &none;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    if (!soup.face_section.empty()) {
      const PolygonSoup::Section* next = &soup.sections[soup.face_section[f]];
      if (next != current) put_section(out, *current, *next);
      current = next;
    }
    out.text("f");
    for (const auto& corner : soup.face(f)) put_corner(out, corner, normals);
    out.text("\n");
  }
}

void put_polylines(OutputBuffer& out, const PolygonSoup& soup) {
  for (std::size_t l = 0; l < soup.line_count(); ++l) {
    out.character('l');
    for (std::uint32_t i = soup.line_begin[l]; i < soup.line_begin[l + 1]; ++i) {
      out.character(' ');
      out.number(soup.line_corners[i] + 1);
    }
    out.character('\n');
  }
}

}  // namespace

void write_obj(const std::filesystem::path& path, const PolygonSoup& soup, const WriteOptions& options) {
  AtomicFile file(path);
  OutputBuffer out(file);
  for (const std::string& line : options.header) put_line(out, "# ", line);
  for (const std::string& name : soup.material_libraries) put_line(out, "mtllib ", name);
  put_positions(out, soup);
  put_lines(out, "vt", soup.texcoords);
  if (options.normals) put_lines(out, "vn", soup.normals);
  put_faces(out, soup, options.normals);
  put_polylines(out, soup);
  out.flush();
  file.commit();
}

}  // namespace multimesh::io
