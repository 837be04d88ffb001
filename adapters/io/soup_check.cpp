// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/soup_check.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "adapters/io/input_location.hpp"
#include "adapters/io/repeated_faces.hpp"
#include "multimesh/coordinate_range.hpp"

namespace multimesh::io {
namespace {

using Corner = PolygonSoup::Corner;

class FaceCheck {
 public:
  FaceCheck(PolygonSoup& soup, std::string_view file, int first_index)
      : soup_(soup), file_(file), total_(soup.face_count()), first_index_(first_index) {}

  void indices() {
    const std::size_t v = soup_.positions.size(), vt = soup_.texcoords.size(), vn = soup_.normals.size();
    for (std::size_t f = 0; f < total_; ++f)
      for (std::uint32_t i = soup_.face_begin[f]; i < soup_.face_begin[f + 1]; ++i) {
        Corner& c = soup_.corners[i];
        if (!in_range(c.v, v)) fail_vertex(f, c.v);
        if (c.vt >= 0 && !in_range(c.vt, vt))
          forget(f, c.vt, soup_.notes.missing_texcoords, first_missing_texcoord_);
        if (c.vn >= 0 && !in_range(c.vn, vn))
          forget(f, c.vn, soup_.notes.missing_normals, first_missing_normal_);
      }
    if (soup_.notes.missing_texcoords != 0)
      warn(first_missing_texcoord_, "the face names a texture coordinate beyond the last one; " +
                                        std::to_string(soup_.notes.missing_texcoords) +
                                        " corners of the file have none now");
    if (soup_.notes.missing_normals != 0)
      warn(first_missing_normal_, "the face names a normal beyond the last one; " +
                                      std::to_string(soup_.notes.missing_normals) +
                                      " corners of the file have none now");
  }

  /// Only points that faces use count.
  void size() const {
    CoordinateRange range;
    for (const Corner& c : soup_.corners) {
      const auto v = static_cast<std::size_t>(c.v);
      range.add(v, soup_.positions[v].data());
    }
    const std::string problem = range.problem(static_cast<std::size_t>(first_index_));
    if (!problem.empty()) fail_file(file_, problem);
  }

  /// Removes repeated corners; a collapsed face keeps its place, with no corners.
  void corners() {
    std::uint32_t end = 0;
    for (std::size_t f = 0; f < total_; ++f) {
      const std::uint32_t begin = end, last = soup_.face_begin[f + 1];
      for (std::uint32_t i = first_; i < last; ++i) {
        const Corner c = soup_.corners[i];
        if (end == begin || soup_.corners[end - 1].v != c.v) soup_.corners[end++] = c;
      }
      while (end - begin > 1 && soup_.corners[end - 1].v == soup_.corners[begin].v) --end;
      end = keep_or_collapse(f, begin, end, last - first_);
      first_ = last;
      soup_.face_begin[f + 1] = end;
    }
    soup_.corners.resize(end);
  }

  void refuse_collapsed(double max_share) {
    if (soup_.notes.collapsed_faces == 0) return;
    const std::string count = ratio(soup_.notes.collapsed_faces);
    if (exceeds(soup_.notes.collapsed_faces, max_share))
      fail(first_collapsed_, "the face has fewer than three distinct vertices (" + count +
                                 " in the file); remove such faces, for instance with a mesh editor");
    warn(first_collapsed_,
         "the face has fewer than three distinct vertices and is left out; " + count + " in the file");
  }

  void warn_repeated_corners() {
    if (soup_.notes.repeated_corners != 0)
      warn(first_repeated_corner_, "the face names a vertex twice in a row, once is kept; " +
                                       std::to_string(soup_.notes.repeated_corners) +
                                       " such corners in the file");
  }

  void refuse_defective(double max_share) {
    std::size_t first_flat = total_;
    for (std::size_t f = total_; f-- > 0;)
      if (!soup_.face(f).empty() && is_flat(soup_.face(f))) {
        first_flat = f;
        ++soup_.notes.flat_faces;
      }
    const auto repeated = repeated_faces(soup_);
    soup_.notes.repeated_faces = repeated.size();
    report(soup_.notes.flat_faces, first_flat, max_share, "the face has no area");
    report(repeated.size(), repeated.empty() ? 0 : repeated.front(), max_share,
           "the face has the same vertices as an earlier face");
  }

  void drop_collapsed() {
    if (soup_.notes.collapsed_faces == 0) return;
    std::size_t kept = 0;
    for (std::size_t f = 0; f < total_; ++f) {
      if (soup_.face_begin[f + 1] == soup_.face_begin[f]) continue;
      soup_.face_line[kept] = soup_.face_line[f];
      soup_.face_section[kept] = soup_.face_section[f];
      soup_.face_begin[++kept] = soup_.face_begin[f + 1];
    }
    soup_.face_begin.resize(kept + 1);
    soup_.face_line.resize(kept);
    soup_.face_section.resize(kept);
    if (kept == 0) fail_file(file_, "no face has three distinct vertices; give a surface");
  }

 private:
  static bool in_range(std::int32_t i, std::size_t size) {
    return i >= 0 && static_cast<std::size_t>(i) < size;
  }

  static void forget(std::size_t f, std::int32_t& i, std::size_t& count, std::size_t& first) {
    if (count++ == 0) first = f;
    i = -1;
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_vertex(std::size_t f, std::int32_t v) const {
    const std::int64_t name = v + std::int64_t{first_index_};
    fail(f, "the face names vertex " + std::to_string(name) + " but the file has " +
                std::to_string(soup_.positions.size()) + "; correct or remove the face");
  }

  std::uint32_t keep_or_collapse(std::size_t f, std::uint32_t begin, std::uint32_t end, std::uint32_t size) {
    if (has_three_vertices(begin, end)) {
      if (end - begin != size && soup_.notes.repeated_corners == 0) first_repeated_corner_ = f;
      soup_.notes.repeated_corners += size - (end - begin);
      return end;
    }
    if (soup_.notes.collapsed_faces++ == 0) first_collapsed_ = f;
    return begin;
  }

  /// No two consecutive corners are equal: three corners are enough; with more, look for a third vertex.
  bool has_three_vertices(std::uint32_t begin, std::uint32_t end) const {
    if (end - begin <= 3) return end - begin == 3;
    const std::int32_t a = soup_.corners[begin].v, b = soup_.corners[begin + 1].v;
    return std::any_of(soup_.corners.begin() + begin, soup_.corners.begin() + end,
                       [&](const Corner& c) { return c.v != a && c.v != b; });
  }

  /// Twice the vector area against the rounding errors of a product of two of its lengths.
  bool is_flat(std::span<const Corner> face) const {
    const auto& o = soup_.positions[static_cast<std::size_t>(face[0].v)];
    std::array<double, 3> area{}, before{};
    double longest = 0;
    for (const Corner& c : face.subspan(1)) {
      const auto& p = soup_.positions[static_cast<std::size_t>(c.v)];
      const std::array<double, 3> d = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
      area[0] += before[1] * d[2] - before[2] * d[1];
      area[1] += before[2] * d[0] - before[0] * d[2];
      area[2] += before[0] * d[1] - before[1] * d[0];
      longest = std::max(longest, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      before = d;
    }
    const double tolerance = 4 * std::numeric_limits<double>::epsilon() * longest;
    return area[0] * area[0] + area[1] * area[1] + area[2] * area[2] <= tolerance * tolerance;
  }

  void report(std::size_t count, std::size_t first, double max_share, const std::string& what) {
    if (count == 0) return;
    if (exceeds(count, max_share))
      fail(first,
           what + " (" + ratio(count) + " in the file); remove such faces, for instance with a mesh editor");
    warn(first, what + "; " + ratio(count) + " in the file, kept");
  }

  bool exceeds(std::size_t count, double max_share) const {
    return static_cast<double>(count) > max_share * static_cast<double>(total_);
  }
  std::string ratio(std::size_t count) const {
    return std::to_string(count) + " of " + std::to_string(total_) + " faces";
  }
  [[noreturn]] void fail(std::size_t f, const std::string& message) const {
    if (soup_.face_line[f] != 0) fail_at(file_, soup_.face_line[f], message);
    fail_file(file_, "face " + std::to_string(f) + " (from 0): " + message);
  }
  void warn(std::size_t f, const std::string& message) {
    std::string warning = file_;
    if (soup_.face_line[f] != 0)
      warning.append(":").append(std::to_string(soup_.face_line[f]));
    else
      warning.append(": face ").append(std::to_string(f)).append(" (from 0)");
    soup_.warnings.push_back(warning.append(": ").append(message));
  }

  PolygonSoup& soup_;
  std::string file_;
  std::size_t total_;
  std::uint32_t first_ = 0;  ///< where the corners of the face being cleaned began before
  int first_index_;
  std::size_t first_missing_texcoord_ = 0;
  std::size_t first_missing_normal_ = 0;
  std::size_t first_collapsed_ = 0;
  std::size_t first_repeated_corner_ = 0;
};

}  // namespace

void check_faces(PolygonSoup& soup, std::string_view file, int first_index, const ReadOptions& options) {
  FaceCheck check(soup, file, first_index);
  check.indices();
  check.size();
  check.corners();
  check.refuse_collapsed(options.max_collapsed_share);
  check.warn_repeated_corners();
  check.refuse_defective(options.max_defective_share);
  check.drop_collapsed();
}

}  // namespace multimesh::io
