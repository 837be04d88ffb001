// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Takes what a reader finds, in any order, and makes a checked soup of it. `where` is the line in a text
/// file, and the number of the element or point in others; errors and warnings name it.
class SimplexBuilder {
 public:
  enum class Where { line, element };

  /// Messages name points as the file counts them, from `first_index`.
  SimplexBuilder(std::string file, Where where, int first_index)
      : file_(std::move(file)), where_(where), first_index_(first_index) {}

  /// \throw InputError when a coordinate is nan or inf.
  void add_point(const std::array<double, 3>& point, std::uint64_t where);
  /// Reserves room for more points. \pre checked against the size of the file
  void reserve_points(std::size_t more) { soup_.points.reserve(soup_.points.size() + more); }
  void reserve(int dimension, std::size_t more);

  /// The index of the point with this `number` in the file; finish() checks whether it exists.
  /// \throw InputError when no file can have that point.
  std::uint32_t point_index(std::int64_t number, std::uint64_t where) const;

  /// \pre corners.size() == dimension + 1
  void add(int dimension, std::span<const std::uint32_t> corners, std::int32_t tag, std::uint64_t where,
           std::uint8_t flags = 0);
  /// A polygon of three corners or more; finish() cuts it into triangles.
  void add_polygon(std::span<const std::uint32_t> corners, std::int32_t tag, std::uint64_t where);
  /// Sets a flag of the simplex with this `number` in the file, among those added so far.
  void add_flag(int dimension, std::int64_t number, SimplexFlag flag, std::uint64_t where);

  /// Puts the simplices of one dimension into this order, by their indices. \pre none has flags
  void reorder(int dimension, std::span<const std::size_t> order);

  /// Something that is not kept, by its name; one warning lists all.
  void left_out(std::string_view name, std::size_t count = 1);
  void warn(const std::string& message) { soup_.warnings.push_back(file_ + ": " + message); }
  SimplexNotes& notes() { return soup_.notes; }
  /// For tags, groups and periodic links, for which the reader is responsible.
  SimplexSoup& soup() { return soup_; }
  /// Does not unite simplices with the same points; the caller does.
  void keep_repeated() { keeps_repeated_ = true; }
  /// The tags of the added polygons that are not triangles, in their order.
  std::vector<std::int32_t>& polygon_tags() { return polygon_tags_; }

  /// Checks every index, cuts polygons into triangles, removes simplices that name a vertex twice, and
  /// makes one of those with the same points (unite_repeated_simplices). \throw InputError for a point
  /// that does not exist, more repeated vertices than `options` allows, and when there is no simplex at
  /// all.
  SimplexSoup finish(const ReadOptions& options);

  [[noreturn]] void fail(std::uint64_t where, const std::string& message) const;

 private:
  std::string place(std::uint64_t where, std::string_view what = "element") const;
  void check_indices(std::span<const std::uint32_t> corners, std::size_t each,
                     std::span<const std::uint64_t> where) const;
  void cut_polygons();
  void remove_repeated(int dimension, const ReadOptions& options);
  void count_unused();
  void add_warnings();

  SimplexSoup soup_;
  std::string file_;
  Where where_;
  int first_index_;
  bool keeps_repeated_ = false;
  std::array<std::vector<std::uint64_t>, 4> simplex_where_;
  std::vector<std::uint32_t> polygon_corners_;
  std::vector<std::size_t> polygon_begin_ = {0};
  std::vector<std::int32_t> polygon_tags_;
  std::vector<std::uint64_t> polygon_where_;
  std::map<std::string, std::size_t, std::less<>> left_out_;
};

}  // namespace multimesh::io
