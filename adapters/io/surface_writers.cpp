// SPDX-License-Identifier: BSD-3-Clause
// STL, OFF and PLY: triangles without tags.
#include <cmath>
#include <limits>

#include "adapters/io/input_location.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

using Point = std::array<double, 3>;

const Point& corner(const SimplexSoup& soup, std::size_t triangle, std::size_t c) {
  return soup.points[soup.simplices[2].corners[3 * triangle + c]];
}

/// Of unit length, 0 0 0 when there is no area; STL wants it, few read it.
Point normal(const SimplexSoup& soup, std::size_t triangle) {
  const Point &a = corner(soup, triangle, 0), &b = corner(soup, triangle, 1), &c = corner(soup, triangle, 2);
  const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0 && std::isfinite(length))) return {0, 0, 0};
  for (double& x : n) x /= length;
  return n;
}

void put_floats(OutputBuffer& out, const Point& p) {
  for (const double x : p) out.little_endian(static_cast<float>(x));
}

void put_text_facet(OutputBuffer& out, const SimplexSoup& soup, std::size_t triangle) {
  out.text("facet normal ");
  put_point(out, normal(soup, triangle));
  out.text("\nouter loop\n");
  for (std::size_t c = 0; c < 3; ++c) {
    out.text("vertex ");
    put_point(out, corner(soup, triangle, c));
    out.character('\n');
  }
  out.text("endloop\nendfacet\n");
}

void check_floats(const SimplexSoup& soup, const std::string& file) {
  for (const Point& p : soup.points)
    for (const double x : p)
      if (std::abs(x) > static_cast<double>(std::numeric_limits<float>::max()))
        fail_file(file, "a coordinate is too large for binary STL; write STL as text, or another format");
}

}  // namespace

void put_stl(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file) {
  const std::size_t count = soup.simplices[2].size();
  if (!binary) {
    out.text("solid multimesh\n");
    for (std::size_t t = 0; t < count; ++t) put_text_facet(out, soup, t);
    return out.text("endsolid multimesh\n");
  }
  check_floats(soup, file);
  if (count > std::numeric_limits<std::uint32_t>::max())
    fail_file(file, "binary STL holds at most 4294967295 triangles; write another format");
  std::string header = "multimesh";  // must not begin with "solid"
  header.resize(80, ' ');
  out.text(header);
  out.little_endian(static_cast<std::uint32_t>(count));
  for (std::size_t t = 0; t < count; ++t) {
    put_floats(out, normal(soup, t));
    for (std::size_t c = 0; c < 3; ++c) put_floats(out, corner(soup, t, c));
    out.little_endian(std::uint16_t{0});
  }
}

void put_off(OutputBuffer& out, const SimplexSoup& soup) {
  const SimplexSoup::Block& triangles = soup.simplices[2];
  out.text("OFF\n");
  out.number(soup.points.size());
  out.character(' ');
  out.number(triangles.size());
  out.text(" 0\n");
  for (const Point& p : soup.points) {
    put_point(out, p);
    out.character('\n');
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    out.text("3 ");
    put_corners(out, triangles, 2, t, 0);
    out.character('\n');
  }
}

void put_ply(OutputBuffer& out, const SimplexSoup& soup, bool binary) {
  const SimplexSoup::Block& triangles = soup.simplices[2];
  out.text("ply\nformat ");
  out.text(binary ? "binary_little_endian" : "ascii");
  out.text(" 1.0\nelement vertex ");
  out.number(soup.points.size());
  out.text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  out.number(triangles.size());
  out.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Point& p : soup.points) {
    if (binary) {
      for (const double x : p) out.little_endian(x);
    } else {
      put_point(out, p);
      out.character('\n');
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (binary) {
      out.little_endian(std::uint8_t{3});
      for (std::size_t c = 0; c < 3; ++c) out.little_endian(triangles.corners[3 * t + c]);
    } else {
      out.text("3 ");
      put_corners(out, triangles, 2, t, 0);
      out.character('\n');
    }
  }
}

}  // namespace multimesh::io
