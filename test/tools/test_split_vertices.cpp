// SPDX-License-Identifier: BSD-3-Clause
// Models whose vertices are written several times, by each command that reads surfaces.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "multimesh/io/mesh_reader.hpp"
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

using io::PolygonSoup;
using Corner = PolygonSoup::Corner;

std::string numbers(const char* statement, std::span<const double> values) {
  std::string line = statement;
  char text[32];
  for (const double x : values) {
    std::snprintf(text, sizeof text, " %.17g", x);
    line += text;
  }
  return line + "\n";
}

/// One vertex for each value of `key` of a corner, with its texture coordinate.
class Split {
 public:
  using Key = std::function<std::array<std::int32_t, 2>(std::size_t corner)>;

  Split(const PolygonSoup& soup, const Key& key) : soup_(soup) {
    std::map<std::array<std::int32_t, 2>, std::size_t> number;
    for (std::size_t c = 0; c < soup.corners.size(); ++c) {
      const auto [at, is_new] = number.try_emplace(key(c), corners_.size());
      if (is_new) corners_.push_back(soup.corners[c]);
      vertex_.push_back(at->second);
    }
  }

  std::size_t vertices() const { return corners_.size(); }

  std::string obj() const {
    std::string text;
    for (const Corner& c : corners_) text += numbers("v", position(c)) + numbers("vt", texcoord(c));
    for (std::size_t f = 0; f < soup_.face_count(); ++f) {
      text += "f";
      for (std::uint32_t i = soup_.face_begin[f]; i < soup_.face_begin[f + 1]; ++i) {
        const std::string n = std::to_string(vertex_[i] + 1);
        text += " " + n + "/" + n;
      }
      text += "\n";
    }
    return text;
  }

  std::string ply() const {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(corners_.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nproperty double s\n"
                       "property double t\nelement face " +
                       std::to_string(soup_.face_count()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Corner& c : corners_) {
      text += numbers("", position(c));
      text.pop_back();
      text += numbers("", texcoord(c));
    }
    for (std::size_t f = 0; f < soup_.face_count(); ++f) {
      text += std::to_string(soup_.face(f).size());
      for (std::uint32_t i = soup_.face_begin[f]; i < soup_.face_begin[f + 1]; ++i)
        text += " " + std::to_string(vertex_[i]);
      text += "\n";
    }
    return text;
  }

 private:
  const std::array<double, 3>& position(const Corner& c) const {
    return soup_.positions[static_cast<std::size_t>(c.v)];
  }
  const std::array<double, 2>& texcoord(const Corner& c) const {
    return soup_.texcoords[static_cast<std::size_t>(c.vt)];
  }

  const PolygonSoup& soup_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> vertex_;
};

Split by_texcoord(const PolygonSoup& soup) {
  return {soup, [&](std::size_t c) { return std::array{soup.corners[c].v, soup.corners[c].vt}; }};
}
Split by_corner(const PolygonSoup& soup) {
  return {soup, [](std::size_t c) { return std::array{static_cast<std::int32_t>(c), 0}; }};
}

/// What is judged of an output: its vertices joined by their places, its triangles by their texture.
struct Judged {
  std::size_t faces, open_edges, flipped;
};

Judged judge(const PolygonSoup& soup) {
  std::map<std::array<double, 3>, std::size_t> place;
  std::vector<std::size_t> at;
  for (const auto& p : soup.positions) at.push_back(place.try_emplace(p, place.size()).first->second);
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  Judged j{soup.face_count(), 0, 0};
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    double area = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Corner &a = face[i], &b = face[(i + 1) % face.size()];
      ++edges[std::minmax(at[static_cast<std::size_t>(a.v)], at[static_cast<std::size_t>(b.v)])];
      const auto &s = soup.texcoords[static_cast<std::size_t>(a.vt)],
                 &t = soup.texcoords[static_cast<std::size_t>(b.vt)];
      area += s[0] * t[1] - s[1] * t[0];
    }
    j.flipped += area < 0;
  }
  for (const auto& [edge, n] : edges) j.open_edges += n == 1;
  return j;
}

class SplitVertices : public ProgramTest {
 protected:
  PolygonSoup model = io::read_mesh(spot());
};

TEST_F(SplitVertices, DecimateLikeJoinedOnes) {
  const Judged before = judge(model);
  for (const bool is_ply : {false, true})
    for (const bool is_soup : {false, true}) {
      const Split split = is_soup ? by_corner(model) : by_texcoord(model);
      const std::string in = file(is_ply ? "in.ply" : "in.obj", is_ply ? split.ply() : split.obj());
      const Ended e = decimate(in, "out.obj", {"--ratio", "0.1", "--report", "r.json"});
      ASSERT_EQ(e.status, 0) << e.err;
      EXPECT_TRUE(contains(e.err, "vertices at exactly the place of another one are joined")) << e.err;
      const Json r = json("r.json");
      EXPECT_EQ(r["target_reached"], true);
      EXPECT_EQ(r["welded"]["welded_vertices"], split.vertices() - model.positions.size());
      const PolygonSoup out = io::read_mesh(directory / "out.obj");
      const Judged after = judge(out);
      EXPECT_EQ(after.faces, r["options"]["target_faces"]);
      EXPECT_EQ(after.open_edges, 0U);
      EXPECT_LE(after.flipped, before.flipped);
      // As split as it came in: one vertex per texture coordinate, with its number.
      EXPECT_EQ(out.positions.size(), out.texcoords.size());
      for (const Corner& c : out.corners) ASSERT_EQ(c.v, c.vt);
    }
}

TEST_F(SplitVertices, RemeshLikeJoinedOnes) {
  file("in.obj", by_texcoord(model).obj());
  const Ended e = run({"remesh", "in.obj", "-o", "out.obj", "--relative-length", "0.04"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_EQ(judge(io::read_mesh(directory / "out.obj")).open_edges, 0U);
  const Json before = info("in.obj")["meshes"], after = info("out.obj")["meshes"];
  for (const char* mesh : {"surface", "texture"})
    for (const char* key : {"components", "euler_characteristic", "boundary_loops"})
      EXPECT_EQ(before[mesh][key], after[mesh][key]) << mesh << key;
}

TEST_F(SplitVertices, StayApartIfWanted) {
  file("in.obj", by_texcoord(model).obj());
  const Ended e = decimate("in.obj", "out.obj", {"--ratio", "0.5", "--no-weld", "--report", "r.json"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_EQ(json("r.json")["welded"]["welded_vertices"], 0);
  EXPECT_TRUE(json("r.json")["options"]["weld"].is_null());
  EXPECT_GT(judge(io::read_mesh(directory / "out.obj")).open_edges, 0U);
  EXPECT_EQ(run({"info", "in.obj", "--no-weld", "--weld", "0.1"}).status, 2);
  EXPECT_EQ(run({"info", "in.obj", "--weld", "-1"}).status, 2);
}

TEST_F(SplitVertices, AreNamedByInfoAndValidate) {
  const Split split = by_texcoord(model), soup = by_corner(model);
  file("split.obj", split.obj());
  file("soup.obj", soup.obj());
  const std::size_t seams = split.vertices() - model.positions.size();
  EXPECT_EQ(info("split.obj")["welded"]["coincident_vertices"], seams);
  EXPECT_TRUE(contains(run({"info", "split.obj"}).out, "coincident vertices: " + std::to_string(seams)));
  // Along seams nothing is wrong; where nothing but the number tells vertices apart, something is.
  const Ended of_split = run({"validate", "split.obj"}), of_soup = run({"validate", "soup.obj"});
  EXPECT_EQ(of_split.status, 0) << of_split.out;
  EXPECT_TRUE(contains(of_split.out, std::to_string(seams) + " other vertices coincide")) << of_split.out;
  EXPECT_EQ(of_soup.status, 1) << of_soup.out;
  EXPECT_TRUE(contains(of_soup.out, "vertices repeat another one")) << of_soup.out;
  EXPECT_EQ(run({"validate", spot()}).status, 0);
}

TEST_F(SplitVertices, CompareEqualToJoinedOnes) {
  file("split.obj", by_texcoord(model).obj());
  const Ended e = run({"compare", spot(), "split.obj", "--json", "--samples", "1000"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json j = Json::parse(e.out);
  EXPECT_EQ(j["original"]["meshes"], j["other"]["meshes"]);
}

TEST_F(SplitVertices, WithinATolerance) {
  PolygonSoup moved = model;
  moved.positions.clear();
  for (Corner& c : moved.corners) {
    auto p = model.positions[static_cast<std::size_t>(c.v)];
    p[moved.positions.size() % 3] += moved.positions.size() % 2 == 0 ? 1e-5 : -1e-5;
    c.v = static_cast<std::int32_t>(moved.positions.size());
    moved.positions.push_back(p);
  }
  file("in.obj", by_corner(moved).obj());
  EXPECT_GT(info("in.obj")["meshes"]["surface"]["boundary_loops"], 1000);
  const Ended e = run({"info", "in.obj", "--json", "--weld", "1e-4"});
  EXPECT_EQ(Json::parse(e.out)["meshes"]["surface"]["boundary_loops"], 0);
}

// Rounding of texture coordinates at one vertex.
TEST_F(SplitVertices, NoiseInTheTextureMakesNoSeams) {
  for (const double noise : {5e-8, 1e-5}) {
    PolygonSoup noisy = model;
    noisy.texcoords.clear();
    double phase = 0;
    for (Corner& c : noisy.corners) {
      const auto& t = model.texcoords[static_cast<std::size_t>(c.vt)];
      phase += 1;
      noisy.texcoords.push_back({t[0] + noise * std::sin(phase), t[1] + noise * std::sin(7 * phase)});
      c.vt = static_cast<std::int32_t>(noisy.texcoords.size() - 1);
    }
    const Split split(noisy, [&](std::size_t c) { return std::array{noisy.corners[c].vt, 0}; });
    file("in.obj", split.obj());
    const std::vector<std::string> weld =
        noise < 1e-6 ? std::vector<std::string>{} : std::vector<std::string>{"--uv-weld", "1e-4"};
    const Ended hint = run({"info", "in.obj"});
    EXPECT_EQ(contains(hint.err, "--uv-weld 0.0001"), noise > 1e-6) << hint.err;
    Arguments arguments = {"--ratio", "0.1", "--report", "r.json"};
    arguments.insert(arguments.end(), weld.begin(), weld.end());
    const Ended e = decimate("in.obj", "out.obj", arguments);
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("r.json"), texture = info(spot())["meshes"]["texture"];
    EXPECT_EQ(r["target_reached"], true) << e.err;
    EXPECT_GT(r["welded"]["welded_texcoords"], 0);
    EXPECT_EQ(r["before"]["texture"]["charts"], texture["charts"]);
    EXPECT_EQ(judge(io::read_mesh(directory / "out.obj")).open_edges, 0U);
  }
}

}  // namespace
}  // namespace multimesh::tools::test
