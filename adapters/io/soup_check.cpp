// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/soup_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "adapters/io/face_warnings.hpp"
#include "adapters/io/input_location.hpp"

namespace multimesh::io {
namespace {

using Corner = PolygonSoup::Corner;

template <std::size_t N>
bool is_finite(const std::array<double, N>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

class SoupCheck {
 public:
  SoupCheck(PolygonSoup& soup, std::string_view file, int first_index)
      : soup_(soup), file_(file), first_index_(first_index) {}

  void indices() {
    const std::size_t v = soup_.positions.size(), vt = soup_.texcoords.size(), vn = soup_.normals.size();
    FirstFace texcoords, normals;
    for (std::size_t f = 0; f < soup_.face_count(); ++f)
      for (std::uint32_t i = soup_.face_begin[f]; i < soup_.face_begin[f + 1]; ++i) {
        Corner& c = soup_.corners[i];
        if (!in_range(c.v, v)) fail_vertex(f, c.v);
        if (c.vt >= 0 && !in_range(c.vt, vt)) forget(f, c.vt, texcoords);
        if (c.vn >= 0 && !in_range(c.vn, vn)) forget(f, c.vn, normals);
      }
    soup_.notes.missing_texcoords = texcoords.count;
    soup_.notes.missing_normals = normals.count;
    warn(texcoords, "the face names a texture coordinate beyond the last one; ");
    warn(normals, "the face names a normal beyond the last one; ");
  }

  void positions(std::span<const NonfinitePosition> nonfinite) {
    if (nonfinite.empty()) return;
    const std::vector<bool> used = used_positions();
    for (const auto& [position, line] : nonfinite)
      if (used[position]) fail_position(position, line);
    // Takes the place of a used position, so that the extent of all positions stays that of the used ones.
    const auto first = static_cast<std::size_t>(std::ranges::find(used, true) - used.begin());
    for (const auto& [position, line] : nonfinite)
      soup_.positions[position] = first < used.size() ? soup_.positions[first] : std::array<double, 3>{};
    soup_.notes.nonfinite_positions = nonfinite.size();
    ignore(nonfinite.size(), "vertices");
  }

  void texcoords() {
    std::vector<bool> bad(soup_.texcoords.size());
    std::size_t left = 0;
    for (std::size_t i = 0; i < bad.size(); ++i) left += bad[i] = !is_finite(soup_.texcoords[i]);
    if (left == 0) return;
    FirstFace faces;
    std::array<double, 2> finite{};
    for (std::size_t f = 0; f < soup_.face_count(); ++f)
      for (std::uint32_t i = soup_.face_begin[f]; i < soup_.face_begin[f + 1]; ++i) {
        Corner& c = soup_.corners[i];
        if (c.vt < 0) continue;
        if (bad[static_cast<std::size_t>(c.vt)])
          forget(f, c.vt, faces);
        else
          finite = soup_.texcoords[static_cast<std::size_t>(c.vt)];
      }
    for (std::size_t i = 0; i < bad.size(); ++i)
      if (bad[i]) soup_.texcoords[i] = finite;
    soup_.notes.nonfinite_texcoords = faces.count;
    warn(faces, "the face names a texture coordinate that is not finite (nan, inf); ");
    if (faces.count == 0) ignore(left, "texture coordinates");
  }

  void colors() {
    for (auto& color : soup_.colors) {
      if (is_finite(color)) continue;
      color = {1, 1, 1};
      ++soup_.notes.nonfinite_colors;
    }
    if (soup_.notes.nonfinite_colors != 0)
      warn("colours that were not finite (nan, inf) are white now: " +
           std::to_string(soup_.notes.nonfinite_colors));
  }

 private:
  static bool in_range(std::int32_t i, std::size_t size) {
    return i >= 0 && static_cast<std::size_t>(i) < size;
  }

  static void forget(std::size_t f, std::int32_t& i, FirstFace& faces) {
    faces.add(f);
    i = -1;
  }

  std::vector<bool> used_positions() const {
    std::vector<bool> used(soup_.positions.size());
    for (const Corner& c : soup_.corners) used[static_cast<std::size_t>(c.v)] = true;
    for (const std::int32_t v : soup_.line_corners) used[static_cast<std::size_t>(v)] = true;
    return used;
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_vertex(std::size_t f, std::int32_t v) const {
    const std::int64_t name = v + std::int64_t{first_index_};
    fail_at_face(soup_, file_, f,
                 "the face names vertex " + std::to_string(name) + " but the file has " +
                     std::to_string(soup_.positions.size()) + "; correct or remove the face");
  }

  [[noreturn]] void fail_position(std::uint32_t position, std::size_t line) const {
    const std::string message =
        "the vertex is not finite (nan, inf or too large); correct it or remove it and its faces";
    if (line != 0) fail_at(file_, line, message);
    fail_file(file_, "vertex " + std::to_string(position) + " (from 0): " + message);
  }

  void warn(std::string message) { soup_.warnings.push_back(file_ + ": " + std::move(message)); }
  void warn(const FirstFace& faces, const std::string& what) {
    if (faces.count != 0)
      warn_at_face(soup_, file_, faces.first,
                   what + std::to_string(faces.count) + " corners of the file have none now");
  }
  void ignore(std::size_t count, const std::string& what) {
    warn(std::to_string(count) + " " + what +
         " that no face names are not finite (nan, inf or too large); they are ignored");
  }

  PolygonSoup& soup_;
  std::string file_;
  int first_index_;
};

}  // namespace

void check_soup(PolygonSoup& soup, std::string_view file, int first_index, const ReadOptions& options,
                std::span<const NonfinitePosition> nonfinite) {
  SoupCheck check(soup, file, first_index);
  check.indices();
  check.positions(nonfinite);
  check.texcoords();
  check.colors();
  clean_faces(soup, file, options.keep_repeated, first_index);
}

}  // namespace multimesh::io
