// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <unordered_map>

#include "adapters/io/face_warnings.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/repeated_faces.hpp"
#include "adapters/io/soup_check.hpp"
#include "multimesh/geometry/coordinate_range.hpp"

namespace multimesh::io {
namespace {

using Corner = PolygonSoup::Corner;

constexpr std::array<double, 2> untextured = {std::numeric_limits<double>::infinity(), 0};

class FaceCleaner {
 public:
  FaceCleaner(PolygonSoup& soup, std::string_view file)
      : soup_(soup), file_(file), total_(soup.face_count()) {}

  /// Removes repeated corners; a collapsed face keeps its place, with no corners.
  void corners() {
    std::size_t f = 0;
    while (f < total_ && is_clean(soup_.face(f))) ++f;
    if (f == total_) return;
    std::uint32_t end = soup_.face_begin[f], first = end;
    for (; f < total_; ++f) {
      const std::uint32_t begin = end, last = soup_.face_begin[f + 1];
      for (std::uint32_t i = first; i < last; ++i) {
        const Corner c = soup_.corners[i];
        if (end == begin || soup_.corners[end - 1].v != c.v) soup_.corners[end++] = c;
      }
      while (end - begin > 1 && soup_.corners[end - 1].v == soup_.corners[begin].v) --end;
      end = keep_or_collapse(f, begin, end, last - first);
      first = last;
      soup_.face_begin[f + 1] = end;
    }
    soup_.corners.resize(end);
    if (collapsed_.count == total_)
      fail_at_face(soup_, file_, collapsed_.first,
                   "the face has fewer than three distinct vertices, and so have all; give a surface");
    report(collapsed_, "the face has fewer than three distinct vertices and is left out");
    soup_.notes.collapsed_faces += collapsed_.count;
    if (repeated_corners_ == 0) return;
    soup_.notes.repeated_corners += repeated_corners_;
    warn_at_face(soup_, file_, first_repeated_corner_,
                 "the face names a vertex twice in a row, once is kept; " +
                     std::to_string(repeated_corners_) + " such corners in the file");
  }

  void flat(int first_index) {
    FirstFace flat;
    for (std::size_t f = 0; f < total_; ++f)
      if (!soup_.face(f).empty() && is_flat(soup_.face(f))) flat.add(f);
    soup_.notes.flat_faces += flat.count;
    if (flat.count + collapsed_.count == total_ && flat.count != 0) {
      check_size(first_index);
      fail_at_face(soup_, file_, flat.first, "the face has no area, and no other face has; give a surface");
    }
    report(flat, "the face has no area and is kept");
  }

  /// \return the faces to be left out
  std::vector<std::uint32_t> repeated(bool keep) {
    std::vector<std::uint32_t> copies;
    FirstFace kept;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> different;  // by the earliest face
    for (const auto& [face, earlier] : repeated_faces(soup_)) {
      auto& others = different.try_emplace(earlier, 1, earlier).first->second;
      const auto same = [&, f = face](std::uint32_t other) { return look_alike(f, other); };
      if (!keep && std::ranges::any_of(others, same)) {
        copies.push_back(face);
      } else {
        kept.add(face);
        others.push_back(face);
      }
    }
    soup_.notes.repeated_faces += copies.size();
    soup_.notes.overlaid_faces += kept.count;
    report({copies.size(), copies.empty() ? 0 : copies.front()},
           "the face has the same vertices as an earlier face and is left out");
    report(kept, std::string("the face has the same vertices as an earlier face") +
                     (keep ? "" : ", but another texture or material,") + " and is kept");
    return copies;
  }

  std::size_t collapsed() const { return collapsed_.count; }

  void remove(std::span<const std::uint32_t> faces) { remove_faces(soup_, faces); }

 private:
  /// Faces may have no area because of the size of the model.
  void check_size(int first_index) const {
    CoordinateRange range;
    for (const Corner& c : soup_.corners)
      range.add(static_cast<std::size_t>(c.v), soup_.positions[static_cast<std::size_t>(c.v)].data());
    const std::string problem = range.problem(static_cast<std::size_t>(first_index));
    if (!problem.empty()) fail_file(file_, problem);
  }

  /// With equal texture coordinates at each vertex, whatever their order, and in one section.
  bool look_alike(std::uint32_t f, std::uint32_t g) const {
    return soup_.sections[soup_.face_section[f]] == soup_.sections[soup_.face_section[g]] &&
           looks(soup_.face(f)) == looks(soup_.face(g));
  }
  std::vector<std::pair<std::int32_t, std::array<double, 2>>> looks(std::span<const Corner> face) const {
    std::vector<std::pair<std::int32_t, std::array<double, 2>>> corners;
    for (const Corner& c : face)
      corners.emplace_back(c.v, c.vt < 0 ? untextured : soup_.texcoords[static_cast<std::size_t>(c.vt)]);
    std::ranges::sort(corners);
    return corners;
  }

  bool is_clean(std::span<const Corner> face) const {
    if (face.size() == 3) return face[0].v != face[1].v && face[1].v != face[2].v && face[2].v != face[0].v;
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i].v == face[(i + 1) % face.size()].v) return false;
    return has_three_vertices(face);
  }

  std::uint32_t keep_or_collapse(std::size_t f, std::uint32_t begin, std::uint32_t end, std::uint32_t size) {
    if (!has_three_vertices({soup_.corners.data() + begin, end - begin})) {
      collapsed_.add(f);
      return begin;
    }
    if (end - begin != size && repeated_corners_ == 0) first_repeated_corner_ = f;
    repeated_corners_ += size - (end - begin);
    return end;
  }

  /// No two consecutive corners are equal: three corners are enough; with more, search for a third vertex.
  static bool has_three_vertices(std::span<const Corner> face) {
    if (face.size() <= 3) return face.size() == 3;
    const std::int32_t a = face[0].v, b = face[1].v;
    return std::ranges::any_of(face, [&](const Corner& c) { return c.v != a && c.v != b; });
  }

  /// Compares twice the vector area with the rounding errors of a product of two of its lengths.
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

  void report(const FirstFace& faces, const std::string& what) {
    if (faces.count != 0)
      warn_at_face(
          soup_, file_, faces.first,
          what + "; " + std::to_string(faces.count) + " of " + std::to_string(total_) + " faces in the file");
  }

  PolygonSoup& soup_;
  std::string file_;
  std::size_t total_;
  FirstFace collapsed_;
  std::size_t repeated_corners_ = 0, first_repeated_corner_ = 0;
};

}  // namespace

void remove_faces(PolygonSoup& soup, std::span<const std::uint32_t> faces) {
  auto next = faces.begin();
  std::size_t kept = 0;
  std::uint32_t end = 0, begin = 0;
  for (std::size_t f = 0; f < soup.face_line.size(); ++f) {
    const std::uint32_t last = soup.face_begin[f + 1];
    const bool is_listed = next != faces.end() && *next == f;
    if (is_listed) ++next;
    if (!is_listed && last != begin) {
      std::copy(soup.corners.begin() + begin, soup.corners.begin() + last, soup.corners.begin() + end);
      end += last - begin;
      soup.face_line[kept] = soup.face_line[f];
      soup.face_section[kept] = soup.face_section[f];
      soup.face_begin[++kept] = end;
    }
    begin = last;
  }
  soup.corners.resize(end);
  soup.face_begin.resize(kept + 1);
  soup.face_line.resize(kept);
  soup.face_section.resize(kept);
}

void remove_collapsed_faces(PolygonSoup& soup, std::string_view file) {
  FaceCleaner cleaner(soup, file);
  cleaner.corners();
  if (cleaner.collapsed() != 0) cleaner.remove({});
}

void clean_faces(PolygonSoup& soup, std::string_view file, bool keep_repeated, int first_index) {
  if (soup.face_count() == 0) return;
  FaceCleaner cleaner(soup, file);
  cleaner.corners();
  cleaner.flat(first_index);
  const std::vector<std::uint32_t> repeated = cleaner.repeated(keep_repeated);
  if (cleaner.collapsed() != 0 || !repeated.empty()) cleaner.remove(repeated);
}

}  // namespace multimesh::io
