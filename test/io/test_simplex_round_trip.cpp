// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <map>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/used_points.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

bool is_msh(const Form& form) {
  return form.name.ends_with(".msh");
}

class SimplexRoundTrip : public IoTest {
 protected:
  SimplexSoup through(const SimplexSoup& soup, const Form& form) {
    warnings = write_simplices(directory / form.name, soup, form.options);
    return read_simplices(directory / form.name);
  }
  std::vector<std::string> warnings;
};

TEST_F(SimplexRoundTrip, EveryVolumeFormatKeepsPointsCornersAndTags) {
  for (const Form& form : volume_forms) {
    SCOPED_TRACE(form.name);
    const SimplexSoup soup = small_soup();
    const SimplexSoup again = through(soup, form);
    expect_same_simplices(soup, again);
    EXPECT_EQ(again.notes.unused_points, 1U);
    const bool has_names = form.name.ends_with(".msh");
    EXPECT_EQ(again.groups, has_names ? soup.groups : std::vector<SimplexSoup::Group>{});
    EXPECT_EQ(warnings.empty(), has_names);
  }
}

TEST_F(SimplexRoundTrip, RandomSoupsComeBackBitByBit) {
  for (unsigned seed = 0; seed < 50; ++seed)
    for (const Form& form : volume_forms) {
      if (form.name == "a.mesh")
        continue;  // a point has one reference there, however many vertices are on it
      SCOPED_TRACE(form.name + " " + std::to_string(seed));
      const SimplexSoup soup = random_soup(seed, is_msh(form) ? 1 : 0);
      const SimplexSoup again = through(soup, form);
      expect_same_simplices(soup, again);
      const std::string written = content(directory / form.name);
      through(again, form);
      EXPECT_EQ(content(directory / form.name), written);
    }
}

/// The simplices of a dimension and the tag that each has, by its corners.
std::map<std::vector<std::uint32_t>, std::int32_t> tags_by_corners(const SimplexSoup& soup, std::size_t k) {
  std::map<std::vector<std::uint32_t>, std::int32_t> tags;
  const auto& block = soup.simplices[k];
  for (std::size_t i = 0; i < block.size(); ++i) {
    const auto begin = block.corners.begin() + static_cast<std::ptrdiff_t>((k + 1) * i);
    tags[{begin, begin + static_cast<std::ptrdiff_t>(k + 1)}] = block.tags[i];
  }
  return tags;
}

TEST_F(SimplexRoundTrip, ZeroTagsStayZeroWhereTheFormatHasThem) {
  for (const Form& form : volume_forms) {
    if (is_msh(form)) continue;
    SCOPED_TRACE(form.name);
    SimplexSoup soup = small_soup();
    for (auto& block : soup.simplices) std::ranges::fill(block.tags, 0);
    soup.groups.clear();
    expect_same_simplices(soup, through(soup, form));
  }
}

TEST_F(SimplexRoundTrip, NegativeTagsWhereTheFormatHasThem) {
  const SimplexSoup soup = small_soup(-2);
  for (const Form& form : volume_forms)
    if (!is_msh(form)) {
      SCOPED_TRACE(form.name);
      expect_same_simplices(soup, through(soup, form));
    }
}

/// Whatever the tags, every element of a Gmsh file has a positive one: equal for equal tags, different for
/// different ones; positive tags are unchanged.
TEST_F(SimplexRoundTrip, GmshTagsArePositiveAndAsDifferentAsBefore) {
  for (int seed = 0; seed < 40; ++seed)
    for (const Form& form : volume_forms) {
      if (!is_msh(form)) continue;
      SCOPED_TRACE(form.name + " " + std::to_string(seed));
      SimplexSoup soup = random_soup(static_cast<unsigned>(seed), seed % 8 - 4);
      soup.groups = {{3, 1, "one"}, {2, -1, "minus one"}};
      const SimplexSoup again = through(soup, form);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto before = tags_by_corners(soup, k), after = tags_by_corners(again, k);
        ASSERT_EQ(before.size(), after.size());
        std::map<std::int32_t, std::int32_t> forward, backward;
        for (const auto& [corners, tag] : before) {
          const std::int32_t now = after.at(corners);
          EXPECT_GT(now, 0);
          EXPECT_TRUE(tag <= 0 || now == tag) << tag << " " << now;
          EXPECT_EQ(forward.try_emplace(tag, now).first->second, now);
          EXPECT_EQ(backward.try_emplace(now, tag).first->second, tag);
        }
        const auto group = [&](std::int32_t tag) {
          return std::ranges::any_of(again.groups, [&](const auto& g) {
            return g.dimension == static_cast<int>(k) && g.tag == tag;
          });
        };
        EXPECT_TRUE(!forward.contains(0) || group(forward[0])) << "has a name";
        EXPECT_TRUE(k != 2 || !forward.contains(-1) || group(forward[-1])) << "keeps its name";
        EXPECT_TRUE(forward.empty() || forward.begin()->first > 0 || !warnings.empty());
      }
    }
}

/// A simplex in several groups is one simplex, in every version, and again when it is written.
TEST_F(SimplexRoundTrip, GroupsThatShareSimplices) {
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const Form& form : volume_forms) {
      if (!is_msh(form)) continue;
      SCOPED_TRACE(form.name + " " + std::to_string(seed));
      SimplexSoup soup = random_soup(seed, 1);
      soup.tag_sets = {{3, 2, {11, 12}}, {2, 1, {11, 13, 17}}, {2, 3, {2, 11}}, {0, 2, {5, 6}}};
      const SimplexSoup once = through(soup, form), again = through(once, form);
      for (const SimplexSoup* read : {&once, &again})
        for (std::size_t k = 0; k < 4; ++k) {
          const auto before = tags_by_corners(soup, k), after = tags_by_corners(*read, k);
          ASSERT_EQ(before.size(), after.size());
          for (const auto& [corners, tag] : before)
            EXPECT_EQ(groups_of(*read, static_cast<int>(k), after.at(corners)),
                      groups_of(soup, static_cast<int>(k), tag));
        }
      EXPECT_EQ(once.notes.doubled, 0U);
    }
}

TEST_F(SimplexRoundTrip, FormatsOfOneTagSayWhatItStandsFor) {
  SimplexSoup soup = small_soup();
  soup.tag_sets = {{3, 9, {1, 2}}};
  for (const Form& form : volume_forms) {
    if (is_msh(form)) continue;
    through(soup, form);
    const auto told = [](const std::string& w) {
      return w.find("tag 9 of tetrahedra stands for the groups 1, 2") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(warnings, told)) << form.name;
  }
}

/// However the regions are interleaved, a file of version 4.1 has one block for each of them.
TEST_F(SimplexRoundTrip, Msh41HasOneBlockForEachEntity) {
  SimplexSoup soup;
  for (std::uint32_t i = 0; i < 3000; ++i) soup.points.push_back({1.0 * i, 0.5 * i, 0.1 * i});
  for (std::uint32_t i = 0; i + 3 < 3000; ++i) {
    for (std::uint32_t c = 0; c < 4; ++c) soup.simplices[3].corners.push_back(i + c);
    soup.simplices[3].tags.push_back(1 + static_cast<std::int32_t>(i * i % 3));
  }
  soup.simplices[2] = {{0, 1, 2, 7, 8, 9, 10, 11, 12}, {1, 2, 1}, {}};
  const SimplexSoup again = through(soup, {"a.msh", {MshVersion::v4_1, false}});
  const std::string text = content(directory / "a.msh");
  const auto blocks_of = [&](const std::string& section) {
    return std::stoul(text.substr(text.find(section) + section.size()));
  };
  EXPECT_EQ(blocks_of("$Elements\n"), 4U) << "two of triangles, and of regions those with squares modulo 3";
  EXPECT_LE(blocks_of("$Nodes\n"), 4U);
  expect_same_simplices(soup, again);
}

TEST_F(SimplexRoundTrip, MeditKeepsFlagsAndPointTags) {
  SimplexSoup soup = small_soup();
  soup.point_tags = {1, 5, 0, 0, 2, -3};
  soup.simplices[0].flags = {feature_flag, feature_flag | required_flag};
  soup.simplices[1].flags = {feature_flag, required_flag};
  soup.simplices[2].flags = {0, 0, required_flag};
  const SimplexSoup again = through(soup, {"a.mesh", {}});
  expect_same_simplices(soup, again);
  EXPECT_EQ(again.point_tags, soup.point_tags);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(again.simplices[k].flags, soup.simplices[k].flags) << k;
  for (const Form& form : volume_forms) {
    through(soup, form);
    const auto names_flags = [](const std::string& w) {
      return w.find("flags of simplices") != std::string::npos;
    };
    EXPECT_EQ(std::ranges::any_of(warnings, names_flags), form.name != "a.mesh");
  }
}

TEST_F(SimplexRoundTrip, LargeArraysOfVtuAreSeveralBlocks) {
  SimplexSoup soup;
  for (std::uint32_t i = 0; i < 100000; ++i) soup.points.push_back({i / 3.0, -1.0 * i, 1e-5 * i});
  for (std::uint32_t i = 0; i + 3 < 100000; ++i) {
    for (std::uint32_t c = 0; c < 4; ++c) soup.simplices[3].corners.push_back(i + c);
    soup.simplices[3].tags.push_back(static_cast<std::int32_t>(1 + i % 5));
  }
  for (const Form& form : volume_forms) {
    SCOPED_TRACE(form.name);
    expect_same_simplices(soup, through(soup, form));
  }
}

TEST_F(SimplexRoundTrip, SurfaceFormatsKeepTriangles) {
  const SimplexSoup soup = small_soup();
  for (const Form& form : surface_forms) {
    SCOPED_TRACE(form.name);
    const SimplexSoup again = through(soup, form);
    EXPECT_FALSE(warnings.empty());
    EXPECT_TRUE(again.simplices[3].tags.empty());
    ASSERT_EQ(again.simplices[2].size(), 3U);
    if (form.name.ends_with(".stl")) continue;
    EXPECT_EQ(bits(again.points), bits(soup.points));
    EXPECT_EQ(again.simplices[2].corners, soup.simplices[2].corners);
    EXPECT_EQ(again.simplices[1].size(), form.name == "a.obj" ? 2U : 0U);
  }
}

TEST_F(SimplexRoundTrip, StlMergesCornersExactly) {
  const SimplexSoup soup = small_soup();
  const SimplexSoup text = through(soup, {"t.stl", {.binary = false}});
  ASSERT_EQ(text.points.size(), 4U);
  EXPECT_EQ(text.notes.merged_points, 5U);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_EQ(text.points[text.simplices[2].corners[i]], soup.points[soup.simplices[2].corners[i]]);
  const SimplexSoup binary = through(soup, {"b.stl", {.binary = true}});
  ASSERT_EQ(binary.points.size(), 4U);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(binary.points[binary.simplices[2].corners[i]][c],
                static_cast<double>(static_cast<float>(soup.points[soup.simplices[2].corners[i]][c])));
  EXPECT_EQ(fs::file_size(directory / "b.stl"), 84U + 3 * 50);
}

TEST_F(SimplexRoundTrip, WhatCannotBeWrittenIsRefusedAndLeavesNothing) {
  SimplexSoup soup = small_soup();
  EXPECT_NE(error_of([&] { write_simplices(directory / "a.xyz", soup); }).find("are not written"),
            std::string::npos);
  EXPECT_NE(error_of([&] { write_simplices(directory / "a.msh.gz", soup); }).find("not written"),
            std::string::npos);
  EXPECT_NE(error_of([&] { write_simplices(directory / "a.msh", {}); }).find("nothing to write"),
            std::string::npos);
  soup.points[0][0] = 1e300;
  EXPECT_NE(error_of([&] { write_simplices(directory / "a.stl", soup); }).find("too large"),
            std::string::npos);
  soup.simplices[2] = {};
  EXPECT_NE(error_of([&] { write_simplices(directory / "a.off", soup); }).find("the mesh has none"),
            std::string::npos);
  EXPECT_TRUE(names_in(directory).empty());
  soup.simplices[3].corners[0] = 17;
  EXPECT_THROW(write_simplices(directory / "a.msh", soup), UsageError);
  EXPECT_TRUE(names_in(directory).empty());
}

TEST_F(SimplexRoundTrip, AnOlderFileStaysWhenWritingFails) {
  const fs::path path = file("a.stl", "old");
  SimplexSoup soup = small_soup();
  soup.points[0][0] = 1e300;  // too large for a float
  EXPECT_NE(error_of([&] { write_simplices(path, soup); }), "");
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(names_in(directory), std::vector<std::string>{"a.stl"});
}

TEST_F(SimplexRoundTrip, UnusedPointsCanBeRemoved) {
  SimplexSoup soup = small_soup();
  soup.points.insert(soup.points.begin(), {{9, 9, 9}});
  for (auto& block : soup.simplices)
    for (std::uint32_t& v : block.corners) ++v;
  soup.periodic = {{0, 1, 2, {}, {{1, 2}, {0, 1}}}};
  const auto map = remove_unused_points(soup);
  constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(map, (std::vector<std::uint32_t>{gone, 0, 1, 2, 3, 4, gone}));
  SimplexSoup expected = small_soup();
  expected.points.pop_back();
  expect_same_simplices(soup, expected);
  EXPECT_EQ(soup.periodic[0].points, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}}));
}

}  // namespace
}  // namespace multimesh::io::test
