// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/textured_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "multimesh/error.hpp"
#include "multimesh/geometry/coordinate_range.hpp"

namespace multimesh {

namespace {

/// A list with one entry per triangle or position, or possibly empty.
void check_length(std::size_t have, std::size_t want, const char* what, const char* of) {
  if (have != 0 && have != want)
    throw InputError(std::to_string(have) + " " + what + " for " + std::to_string(want) + " " + of +
                     "; give one each, or none");
}

void check_lengths(const TexturedTriangles& input) {
  const std::size_t triangles = input.triangles.size();
  if (triangles == 0) throw InputError("the surface has no triangles");
  check_length(input.labels.size(), triangles, "labels", "triangles");
  check_length(input.shading.size(), triangles, "entries of shading", "triangles");
  check_length(input.colors.size(), input.positions.size(), "colours", "positions");
  for (const auto& set : input.more_uv_sets)
    if (set.corners.size() != triangles)
      throw InputError("a further set of texture coordinates has the corners of " +
                       std::to_string(set.corners.size()) + " triangles; the surface has " +
                       std::to_string(triangles));
}

void check_texcoords(const TexturedTriangles& input, std::size_t set, std::size_t t) {
  int without = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t vt = input.texcoord(set, t, i);
    if (vt >= 0 && static_cast<std::size_t>(vt) >= input.texcoords_of(set).size())
      throw InputError("triangle " + std::to_string(t) + ": no texture coordinate " + std::to_string(vt));
    without += vt < 0;
  }
  if (without != 0 && without != 3)
    throw InputError("triangle " + std::to_string(t) +
                     " has texture coordinates on some corners only; give all three or none");
}

constexpr double most = CoordinateRange::largest_coordinate;

template <class Point>
bool is_small(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) <= most; });
}

/// For the whole list, whether triangles use the points or not: far cheaper than checking corner by corner.
template <class Point>
bool all_small(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), is_small<Point>);
}

/// Except for a tiny model, the first triangles decide.
bool has_extent(const TexturedTriangles& input) {
  return std::any_of(input.triangles.begin(), input.triangles.end(), [&](const auto& t) {
    const auto at = [&](std::size_t i) { return input.positions[static_cast<std::size_t>(t[i].position)]; };
    const Vec3 side = at(1) - at(0);
    return std::max({std::abs(side[0]), std::abs(side[1]), std::abs(side[2])}) >=
           CoordinateRange::least_extent;
  });
}

void check_position_sizes(const TexturedTriangles& input) {
  CoordinateRange range;
  for (const auto& t : input.triangles)
    for (const auto& c : t) {
      const auto i = static_cast<std::size_t>(c.position);
      range.add(i, input.positions[i].data());
    }
  if (const std::string problem = range.problem(); !problem.empty()) throw InputError(problem);
}

void check_texcoord_sizes(const TexturedTriangles& input, std::size_t set) {
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t vt = input.texcoord(set, t, i);
      if (vt >= 0 && !is_small(input.texcoords_of(set)[static_cast<std::size_t>(vt)]))
        throw InputError("triangle " + std::to_string(t) +
                         " (from 0) has a texture coordinate that is too large, or not a number; correct it");
    }
}

}  // namespace

void check_size(const TexturedTriangles& input) {
  for (std::size_t set = 0; set < input.uv_sets(); ++set)
    if (!all_small(input.texcoords_of(set))) check_texcoord_sizes(input, set);
  if (!all_small(input.positions) || !has_extent(input)) check_position_sizes(input);
}

void check(const TexturedTriangles& input) {
  check_lengths(input);
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    for (const auto& c : input.triangles[t])
      if (c.position < 0 || static_cast<std::size_t>(c.position) >= input.positions.size())
        throw InputError("triangle " + std::to_string(t) + ": no position " + std::to_string(c.position));
    for (std::size_t set = 0; set < input.uv_sets(); ++set) check_texcoords(input, set, t);
  }
  check_size(input);
}

}  // namespace multimesh
