// SPDX-License-Identifier: BSD-3-Clause
// Soups in any state become faces, exactly.
#include <gtest/gtest.h>

#include <cstdlib>

#include "test/insertion/check.hpp"
#include "test/insertion/soups.hpp"

namespace multimesh::test {
namespace {

/// Per kind; MULTIMESH_SOUPS sets another number.
unsigned soups() {
  const char* more = std::getenv("MULTIMESH_SOUPS");
  return more ? unsigned(std::strtoul(more, nullptr, 10)) : 40;
}

class Insert : public testing::TestWithParam<SoupKind> {};

TEST_P(Insert, MakesFacesOfAllTriangles) {
  for (unsigned seed = 1; seed <= soups(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TriangleSoup soup = GetParam().make(seed);
    const BackgroundMesh background = background_of(soup);
    for (const bool merge : {true, false})
      for (const bool snap : {true, false}) {
        if (!snap && soup.triangles.size() > 6) continue;  // numbers grow too long
        InsertOptions options;
        options.merge_coplanar = merge, options.snap = snap, options.round = false;
        options.thin = snap == (seed % 2 == 0);
        options.most_points = 100'000;
        const Arrangement a = insert(soup, background, options);
        ASSERT_EQ(faults(soup, background, a), std::vector<std::string>{}) << merge << snap;
      }
  }
}
INSTANTIATE_TEST_SUITE_P(Soups, Insert, testing::ValuesIn(soup_kinds()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace multimesh::test
