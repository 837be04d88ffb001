// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/simplex_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "adapters/io/input_location.hpp"
#include "adapters/io/repeated_simplices.hpp"
#include "adapters/io/simplex_names.hpp"
#include "multimesh/io/triangulate.hpp"

namespace multimesh::io {

void SimplexBuilder::add_point(const std::array<double, 3>& point, std::uint64_t where) {
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
    fail_file(place(where, "point"),
              "the point is not finite (nan, inf or too large); correct it or remove it and its elements");
  if (soup_.points.size() == std::numeric_limits<std::uint32_t>::max())
    fail(where, "more than 4294967295 points; split the file");
  soup_.points.push_back(point);
}

void SimplexBuilder::reserve(int dimension, std::size_t more) {
  const auto k = static_cast<std::size_t>(dimension);
  SimplexSoup::Block& block = soup_.simplices[k];
  block.corners.reserve(block.corners.size() + (k + 1) * more);
  block.tags.reserve(block.tags.size() + more);
  simplex_where_[k].reserve(simplex_where_[k].size() + more);
}

std::uint32_t SimplexBuilder::point_index(std::int64_t number, std::uint64_t where) const {
  if (number >= first_index_ && number - first_index_ < std::numeric_limits<std::uint32_t>::max())
    return static_cast<std::uint32_t>(number - first_index_);
  fail(where, "point number " + std::to_string(number) + " is out of range; points count from " +
                  std::to_string(first_index_) + ", correct or remove the element");
}

void SimplexBuilder::add(int dimension, std::span<const std::uint32_t> corners, std::int32_t tag,
                         std::uint64_t where, std::uint8_t flags) {
  const auto k = static_cast<std::size_t>(dimension);
  SimplexSoup::Block& block = soup_.simplices[k];
  block.corners.insert(block.corners.end(), corners.begin(), corners.end());
  block.tags.push_back(tag);
  simplex_where_[k].push_back(where);
  if (flags != 0) block.flags.resize(block.size() - 1);
  if (flags != 0 || !block.flags.empty()) block.flags.push_back(flags);
}

void SimplexBuilder::add_polygon(std::span<const std::uint32_t> corners, std::int32_t tag,
                                 std::uint64_t where) {
  if (corners.size() == 3) return add(2, corners, tag, where);
  if (corners.size() < 3)
    fail(where, "the polygon has " + std::to_string(corners.size()) +
                    " corners; remove it or give it three or more");
  polygon_corners_.insert(polygon_corners_.end(), corners.begin(), corners.end());
  polygon_begin_.push_back(polygon_corners_.size());
  polygon_tags_.push_back(tag);
  polygon_where_.push_back(where);
}

void SimplexBuilder::add_flag(int dimension, std::int64_t number, SimplexFlag flag, std::uint64_t where) {
  const auto k = static_cast<std::size_t>(dimension);
  SimplexSoup::Block& block = soup_.simplices[k];
  const std::int64_t i = number - first_index_;
  if (i < 0 || static_cast<std::uint64_t>(i) >= block.size())
    fail(where, std::string(simplex_names[k]) + " number " + std::to_string(number) +
                    " is out of range; the file has " + std::to_string(block.size()) + ", correct the list");
  block.flags.resize(block.size());
  block.flags[static_cast<std::size_t>(i)] |= flag;
}

void SimplexBuilder::reorder(int dimension, std::span<const std::size_t> order) {
  const auto k = static_cast<std::size_t>(dimension);
  SimplexSoup::Block& block = soup_.simplices[k];
  const std::vector<std::uint64_t> where = std::move(simplex_where_[k]);
  const SimplexSoup::Block before = std::exchange(block, {});
  simplex_where_[k] = {};
  for (const std::size_t i : order)
    add(dimension, std::span(before.corners).subspan((k + 1) * i, k + 1), before.tags[i], where[i]);
}

void SimplexBuilder::left_out(std::string_view name, std::size_t count) {
  soup_.notes.left_out += count;
  left_out_[std::string(name)] += count;
}

SimplexSoup SimplexBuilder::finish(const ReadOptions& options) {
  for (std::size_t k = 0; k < 4; ++k) check_indices(soup_.simplices[k].corners, k + 1, simplex_where_[k]);
  cut_polygons();
  for (int k = 3; k >= 0; --k) remove_repeated(k, options);
  if (soup_.dimension() < 0)
    fail_file(file_, "the file has no tetrahedron, triangle, edge or vertex; give a mesh");
  for (SimplexSoup::Block& block : soup_.simplices)
    if (!block.flags.empty()) block.flags.resize(block.size());
  if (!soup_.point_tags.empty()) soup_.point_tags.resize(soup_.points.size());
  if (!keeps_repeated_) unite_repeated_simplices(soup_);
  count_unused();
  add_warnings();
  return std::move(soup_);
}

void SimplexBuilder::fail(std::uint64_t where, const std::string& message) const {
  fail_file(place(where), message);
}

std::string SimplexBuilder::place(std::uint64_t where, std::string_view what) const {
  if (where_ == Where::line) return file_ + ":" + std::to_string(where);
  return file_ + ": " + std::string(what) + " " + std::to_string(where);
}

void SimplexBuilder::check_indices(std::span<const std::uint32_t> corners, std::size_t each,
                                   std::span<const std::uint64_t> where) const {
  const auto wrong = std::ranges::find_if(corners, [&](auto i) { return i >= soup_.points.size(); });
  if (wrong == corners.end()) return;
  fail(where[static_cast<std::size_t>(wrong - corners.begin()) / each],
       "the element names point " + std::to_string(std::int64_t{*wrong} + first_index_) +
           " but the file has " + std::to_string(soup_.points.size()) + "; correct or remove the element");
}

/// Uses the existing triangulation, on a soup of only the polygons.
void SimplexBuilder::cut_polygons() {
  if (polygon_tags_.empty()) return;
  if (polygon_corners_.size() > std::numeric_limits<std::uint32_t>::max())
    fail_file(file_, "more than 4294967295 corners of polygons; split the file");
  PolygonSoup polygons;
  for (std::size_t f = 0; f < polygon_tags_.size(); ++f) {
    const auto corners =
        std::span(polygon_corners_).subspan(polygon_begin_[f], polygon_begin_[f + 1] - polygon_begin_[f]);
    check_indices(corners, corners.size(), std::span(polygon_where_).subspan(f, 1));
    for (const std::uint32_t v : corners) polygons.corners.push_back({static_cast<std::int32_t>(v), -1, -1});
    polygons.face_begin.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  if (soup_.points.size() > std::numeric_limits<std::int32_t>::max())
    fail_file(file_, "more than 2147483647 points in a file with polygons; split them into triangles");
  polygons.positions.swap(soup_.points);
  const TriangleSoup cut = triangulate(polygons);
  soup_.points.swap(polygons.positions);
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = static_cast<std::uint32_t>(cut.triangles[t][i].v);
    add(2, corners, polygon_tags_[cut.polygon[t]], polygon_where_[cut.polygon[t]]);
  }
  soup_.notes.cut_polygons = polygon_tags_.size();
}

void SimplexBuilder::remove_repeated(int dimension, const ReadOptions& options) {
  const auto k = static_cast<std::size_t>(dimension);
  SimplexSoup::Block& block = soup_.simplices[k];
  const std::size_t total = block.size(), each = k + 1;
  std::vector<bool> removed(total);
  for (std::size_t i = 0; i < total; ++i)
    removed[i] = names_a_point_twice(std::span(block.corners).subspan(each * i, each));
  const auto first = static_cast<std::size_t>(std::ranges::find(removed, true) - removed.begin());
  const std::size_t kept = static_cast<std::size_t>(std::ranges::count(removed, false));
  if (kept == total) return;
  const std::string count = std::to_string(total - kept) + " of " + std::to_string(total) + " " +
                            simplex_plurals[k] + " in the file";
  const std::string message = std::string("the ") + simplex_names[k] + " names a point twice";
  if (static_cast<double>(total - kept) > options.max_collapsed_share * static_cast<double>(total))
    fail(simplex_where_[k][first], message + " (" + count + "); remove such elements");
  soup_.warnings.push_back(place(simplex_where_[k][first]) + ": " + message + " and is left out; " + count);
  soup_.notes.repeated_vertex += total - kept;
  remove_simplices(block, removed);
}

void SimplexBuilder::count_unused() {
  std::vector<bool> used(soup_.points.size());
  for (const SimplexSoup::Block& block : soup_.simplices)
    for (const std::uint32_t v : block.corners) used[v] = true;
  soup_.notes.unused_points = static_cast<std::size_t>(std::ranges::count(used, false));
}

void SimplexBuilder::add_warnings() {
  const SimplexNotes& n = soup_.notes;
  const auto say = [&](std::size_t count, const std::string& rest) {
    if (count != 0) warn(std::to_string(count) + rest);
  };
  say(n.high_order, " elements are of higher order; their corners are kept, and no other of their points");
  say(n.cut_polygons, " polygons of four or more corners are cut into triangles");
  say(n.doubled, " elements are listed again with the same points and tag; they are left out");
  // Points of elements of higher order are reported above.
  if (n.high_order == 0) say(n.unused_points, " points belong to no element; they are not used");
  if (left_out_.empty()) return;
  std::string list;
  for (const auto& [name, count] : left_out_) {
    list += (list.empty() ? "" : ", ") + name;
    if (count != 1) list += " (" + std::to_string(count) + ")";
  }
  warn("left out: " + list);
}

}  // namespace multimesh::io
