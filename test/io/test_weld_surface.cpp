// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/weld_surface.hpp"

namespace multimesh::io::test {
namespace {

using Corner = PolygonSoup::Corner;

PolygonSoup obj(const std::string& text) {
  return parse_mesh(text, "a.obj");
}

/// A torus of n x n quads, cut in the texture along one line each way, with normals that break along a third.
PolygonSoup torus(int n) {
  std::string text;
  const auto number = [](double x) { return " " + std::to_string(x); };
  const double turn = 2 * 3.14159265358979 / n;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      text += "v" + number((3 + std::cos(turn * y)) * std::cos(turn * x)) +
              number((3 + std::cos(turn * y)) * std::sin(turn * x)) + number(std::sin(turn * y)) + "\n";
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) text += "vt" + number(1.0 * x / n) + number(1.0 * y / n) + "\n";
  text += "vn 0 0 1\nvn 0 0 -1\n";
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      text += "f";
      for (const auto& [i, j] : {std::pair{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}})
        text += " " + std::to_string(j % n * n + i % n + 1) + "/" + std::to_string(j * (n + 1) + i + 1) +
                "/" + (y < n / 2 ? "1" : "2");
      text += "\n";
    }
  return obj(text);
}

enum class Split { by_texcoord, by_texcoord_and_normal, by_corner };

/// The same surface with vertices, texture coordinates and normals written as exporters do, in random order.
PolygonSoup split(const PolygonSoup& soup, Split how, std::mt19937& random) {
  std::vector<std::array<std::int32_t, 4>> keys;
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    const Corner& k = soup.corners[c];
    keys.push_back({k.v, k.vt, how == Split::by_texcoord ? -1 : k.vn,
                    how == Split::by_corner ? static_cast<std::int32_t>(c) : -1});
  }
  std::vector<std::array<std::int32_t, 4>> order(keys);
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::ranges::shuffle(order, random);
  std::map<std::array<std::int32_t, 4>, std::int32_t> number;
  PolygonSoup out = soup;
  out.positions.clear();
  out.texcoords.clear();
  for (const auto& key : order) {
    number[key] = static_cast<std::int32_t>(out.positions.size());
    out.positions.push_back(soup.positions[static_cast<std::size_t>(key[0])]);
    out.texcoords.push_back(soup.texcoords[static_cast<std::size_t>(key[1])]);
  }
  for (std::size_t c = 0; c < keys.size(); ++c) out.corners[c].v = out.corners[c].vt = number[keys[c]];
  return out;
}

/// Per corner the first one with the same vertex, and the first one with the same vertex and texture
/// coordinate.
std::vector<std::array<std::size_t, 2>> partition(const PolygonSoup& soup) {
  std::map<std::int32_t, std::size_t> vertex;
  std::map<std::tuple<std::int32_t, double, double>, std::size_t> wedge;
  std::vector<std::array<std::size_t, 2>> first;
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    const Corner& k = soup.corners[c];
    std::array<double, 2> uv{-9, -9};
    if (k.vt >= 0) uv = soup.texcoords[static_cast<std::size_t>(k.vt)];
    first.push_back(
        {vertex.try_emplace(k.v, c).first->second, wedge.try_emplace({k.v, uv[0], uv[1]}, c).first->second});
  }
  return first;
}

std::size_t used_vertices(const PolygonSoup& soup) {
  std::set<std::int32_t> used;
  for (const Corner& c : soup.corners) used.insert(c.v);
  return used.size();
}

std::size_t open_edges(const PolygonSoup& soup) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> faces;
  for (std::size_t f = 0; f < soup.face_count(); ++f)
    for (std::size_t i = 0; i < soup.face(f).size(); ++i) {
      const auto [a, b] = std::minmax(soup.face(f)[i].v, soup.face(f)[(i + 1) % soup.face(f).size()].v);
      ++faces[{a, b}];
    }
  return static_cast<std::size_t>(std::ranges::count_if(faces, [](const auto& e) { return e.second == 1; }));
}

TEST(WeldSurface, SplitVerticesComeTogetherAsTheyWere) {
  std::mt19937 random(1);
  for (const int n : {4, 5, 9, 16})
    for (const Split how : {Split::by_texcoord, Split::by_texcoord_and_normal, Split::by_corner}) {
      const PolygonSoup whole = torus(n);
      PolygonSoup soup = split(whole, how, random);
      const std::size_t vertices = soup.positions.size();
      const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
      EXPECT_EQ(partition(soup), partition(whole));
      EXPECT_EQ(report.welded, vertices - whole.positions.size());
      EXPECT_EQ(report.coincident, report.welded);
      EXPECT_TRUE(report.split_by_texcoord);
      EXPECT_EQ(report.split_by_normal, how != Split::by_texcoord);
      EXPECT_EQ(report.redundant == 0, how != Split::by_corner);
      EXPECT_EQ(report.copied_faces, 0U);
      EXPECT_EQ(soup.warnings, whole.warnings);
    }
}

TEST(WeldSurface, AWeldedSurfaceIsLeftAlone) {
  const PolygonSoup whole = torus(7);
  PolygonSoup soup = whole;
  const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
  EXPECT_EQ(soup.corners, whole.corners);
  EXPECT_EQ(report.coincident + report.welded + report.texcoords + report.near_texcoords, 0U);
  EXPECT_FALSE(report.split_by_texcoord || report.split_by_normal);
}

TEST(WeldSurface, NoneIfNotWanted) {
  std::mt19937 random(1);
  PolygonSoup soup = split(torus(5), Split::by_corner, random);
  const auto before = soup.corners;
  EXPECT_EQ(weld_surface(soup, {.positions = false}, "a.obj").welded, 0U);
  EXPECT_EQ(soup.corners, before);
}

// Noise in the last place of single precision makes no seams; a seam stays one.
TEST(WeldSurface, RoundingOfTextureCoordinatesMakesNoSeam) {
  std::mt19937 random(2);
  for (const double size : {1.0, 30.0, 1000.0}) {
    PolygonSoup whole = torus(12);
    for (auto& t : whole.texcoords)
      for (double& x : t) x *= size;
    for (const Split how : {Split::by_texcoord, Split::by_corner}) {
      PolygonSoup soup = split(whole, how, random);
      std::uniform_real_distribution<double> noise(-6e-8, 6e-8);
      if (how == Split::by_corner)
        for (auto& t : soup.texcoords)
          for (double& x : t) x += noise(random) * std::max(1.0, x);
      const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
      EXPECT_EQ(partition(soup), partition(whole));
      EXPECT_EQ(report.texcoords > 0, how == Split::by_corner);
      EXPECT_EQ(report.near_texcoords, 0U);
    }
  }
}

TEST(WeldSurface, LargerNoiseIsToldAndJoinedIfWanted) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
  const PolygonSoup whole = torus(12);
  PolygonSoup noisy = split(whole, Split::by_corner, random);
  for (auto& t : noisy.texcoords)
    for (double& x : t) x += noise(random);
  PolygonSoup soup = noisy;
  const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
  EXPECT_EQ(report.near_texcoords,
            whole.positions.size() - 1);  // but for the one that is in all four corners
  EXPECT_GT(report.near_texcoord_distance, 1e-5);
  EXPECT_LT(report.near_texcoord_distance, 3e-5);
  EXPECT_EQ(weld_surface(noisy, {.texcoord_tolerance = 1e-4}, "a.obj").near_texcoords, 0U);
  EXPECT_EQ(partition(noisy), partition(whole));
}

// If joined, the small triangle would have its three corners at one place, or flip.
TEST(WeldSurface, NoFaceTurnsOverInTheTexture) {
  PolygonSoup soup =
      obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1e-8 0\nvt 0 1e-8\nvt 0 2e-8\nvt 2e-8 0\nvt 1 1\n"
          "f 1/1 2/2 3/3\nf 2/4 4/6 3/5\n");
  const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
  for (std::size_t f = 0; f < 2; ++f) {
    std::array<std::array<double, 2>, 3> t;
    for (std::size_t i = 0; i < 3; ++i) t[i] = soup.texcoords[static_cast<std::size_t>(soup.face(f)[i].vt)];
    const double area = (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
    EXPECT_EQ(area > 0, f == 0) << area;
  }
  EXPECT_EQ(report.near_texcoords, 0U);
}

/// A unit cube at (x, y, z), with quads from vertex number `first`.
std::string cube(double x, double y, double z, int first) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(x + (i & 1)) + " " + std::to_string(y + (i >> 1 & 1)) + " " +
            std::to_string(z + (i >> 2)) + "\n";
  for (const auto& q :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    text += "f " + std::to_string(first + q[0]) + " " + std::to_string(first + q[1]) + " " +
            std::to_string(first + q[2]) + " " + std::to_string(first + q[3]) + "\n";
  return text;
}

/// Every corner a vertex of its own.
PolygonSoup exploded(PolygonSoup soup) {
  std::vector<std::array<double, 3>> positions;
  for (Corner& c : soup.corners) {
    positions.push_back(soup.positions[static_cast<std::size_t>(c.v)]);
    c.v = static_cast<std::int32_t>(positions.size() - 1);
  }
  soup.positions.swap(positions);
  return soup;
}

// At a vertex, along an edge, at a whole face.
TEST(WeldSurface, ClosedPartsThatTouchStayApart) {
  const std::vector<std::array<double, 3>> offsets{{1, 1, 1}, {1, 1, 0}, {1, 0, 0}};
  const std::array<std::size_t, 3> common{1, 2, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z] = offsets[i];
    const std::string text = cube(0, 0, 0, 1) + cube(x, y, z, 9);
    PolygonSoup soup = obj(text);
    const auto before = soup.corners;
    const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
    EXPECT_EQ(report.coincident, common[i]);
    EXPECT_EQ(report.welded, 0U);
    EXPECT_EQ(report.copied_faces, 0U);
    EXPECT_EQ(soup.corners, before);
    // Nothing tells any more which corner belongs to which cube. Where whole faces touch, those of the second
    // cube are in a separate layer, and nothing of either is lost.
    soup = exploded(obj(text));
    weld_surface(soup, {}, "a.obj");
    EXPECT_EQ(soup.face_count(), 12U);
    if (i < 2) {
      EXPECT_EQ(used_vertices(soup), 16 - common[i]);
      EXPECT_EQ(open_edges(soup), 0U);
    }
  }
}

// A sheet of n x n quads that is listed for both sides, with vertices of its own for each, or for each
// corner.
TEST(WeldSurface, TheSidesOfASheetStayApart) {
  for (const int n : {1, 2, 5})
    for (const bool is_exploded : {false, true}) {
      std::string text, front, back;
      for (int side = 0; side < 2; ++side)
        for (int y = 0; y <= n; ++y)
          for (int x = 0; x <= n; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
      const auto vertex = [&](int side, int x, int y) {
        return " " + std::to_string(side * (n + 1) * (n + 1) + y * (n + 1) + x + 1);
      };
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          front += "f" + vertex(0, x, y) + vertex(0, x + 1, y) + vertex(0, x + 1, y + 1) +
                   vertex(0, x, y + 1) + "\n";
          back += "f" + vertex(1, x, y) + vertex(1, x, y + 1) + vertex(1, x + 1, y + 1) +
                  vertex(1, x + 1, y) + "\n";
        }
      PolygonSoup soup = obj(text + front + back);
      if (is_exploded) soup = exploded(soup);
      const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
      EXPECT_EQ(soup.face_count(), 2U * n * n);
      EXPECT_EQ(used_vertices(soup), 2U * (n + 1) * (n + 1));
      EXPECT_EQ(open_edges(soup), 8U * n);
      EXPECT_EQ(report.copied_faces, 0U);
    }
}

TEST(WeldSurface, CopiesOfFacesAreLeftOut) {
  const PolygonSoup whole = torus(6);
  std::mt19937 random(4);
  PolygonSoup soup = split(whole, Split::by_corner, random);
  const std::size_t faces = soup.face_count(), corners = soup.corners.size();
  for (std::size_t f = 0; f < faces; f += 2) {
    // Turned by one corner, with vertices of its own.
    for (std::size_t i = 0; i < 4; ++i) {
      Corner c = soup.corners[4 * f + (i + 1) % 4];
      soup.positions.push_back(soup.positions[static_cast<std::size_t>(c.v)]);
      c.v = static_cast<std::int32_t>(soup.positions.size() - 1);
      soup.corners.push_back(c);
    }
    soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    soup.face_line.push_back(0);
    soup.face_section.push_back(0);
  }
  const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
  EXPECT_EQ(report.copied_faces, faces / 2);
  EXPECT_EQ(soup.corners.size(), corners);
  EXPECT_EQ(partition(soup), partition(whole));
}

TEST(WeldSurface, ColoursThatDifferAreBlendedAndCounted) {
  const std::string strip = "f 1 2 3\nf 4 5 6\n";
  PolygonSoup soup = obj(
      "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 0 0 1 0 0\nv 1 1 0 0 1 0\nv 0 1 0 0 1 0\n" + strip);
  const SurfaceWeldReport report = weld_surface(soup, {}, "a.obj");
  EXPECT_EQ(report.welded, 2U);
  EXPECT_EQ(report.blended_colors, 1U);
  EXPECT_EQ(report.redundant, 1U);
  EXPECT_EQ(soup.colors.at(0), (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(soup.colors.at(2), (std::array<double, 3>{0.5, 0.5, 0}));
}

TEST(WeldSurface, WithinATolerance) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  const PolygonSoup whole = torus(10);
  PolygonSoup soup = split(whole, Split::by_corner, random);
  for (auto& p : soup.positions)
    for (double& x : p) x += noise(random);
  PolygonSoup exact = soup;
  EXPECT_EQ(weld_surface(exact, {}, "a.obj").welded, 0U);
  weld_surface(soup, {.tolerance = 1e-3}, "a.obj");
  EXPECT_EQ(partition(soup), partition(whole));
}

TEST(WeldSurface, FacesThatCollapseAreLeftOutWithAWarning) {
  PolygonSoup soup = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1.0001 0 0\nf 1 2 3\nf 2 4 3\n");
  const SurfaceWeldReport report = weld_surface(soup, {.tolerance = 1e-3}, "a.obj");
  EXPECT_EQ(report.welded, 1U);
  EXPECT_EQ(soup.face_count(), 1U);
  EXPECT_NE(soup.warnings.at(0).find("a.obj:6: the face has fewer than three distinct vertices"),
            std::string::npos);
}

}  // namespace
}  // namespace multimesh::io::test
