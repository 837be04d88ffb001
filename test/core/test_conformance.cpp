// SPDX-License-Identifier: BSD-3-Clause
// The contract of every mesh about darts and neighbourhoods, against brute force over vertex sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "multimesh/faces.hpp"
#include "test/core/bridge.hpp"
#include "test/core/mesh_cases.hpp"

namespace multimesh::test {
namespace {

class Conformance : public testing::TestWithParam<MeshCase> {
 protected:
  Conformance() : mesh_(GetParam().make()), d_(mesh_->dimension()) {}

  std::vector<Index> vertices(Dart dart, int k) const {
    std::vector<Index> v(4);
    mesh_->vertices(dart, v.data());
    v.resize(static_cast<std::size_t>(k) + 1);
    return v;
  }
  oracle::Simplex simplex(Dart dart, int k) const {
    oracle::Simplex s{k + 1, {}};
    auto v = vertices(dart, k);
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < v.size(); ++i) s.v[i] = static_cast<int>(v[i]);
    return s;
  }

  std::unique_ptr<Mesh> mesh_;
  int d_;
};

TEST_P(Conformance, IsConnectedCorrectly) {
  std::vector<std::string> problems;
  mesh_->check(problems);
  EXPECT_EQ(problems, std::vector<std::string>{});
  EXPECT_EQ(oracle::manifold_error(complex_of(*mesh_)), "");
}

TEST_P(Conformance, HasAllOrderingsOfEachFacetAsDarts) {
  const std::size_t orderings = number_of_orders(d_);
  for (const Dart f : simplices_of(*mesh_, d_)) {
    std::set<std::uint32_t> codes;
    std::set<std::vector<Index>> orders;
    for (std::uint8_t p = 0; p < orderings; ++p) {
      const Dart d = mesh_->reorder(f, {p});
      EXPECT_TRUE(mesh_->is_dart(d));
      EXPECT_EQ(mesh_->facet(d), mesh_->facet(f));
      codes.insert(code(d));
      orders.insert(vertices(d, d_));
    }
    EXPECT_EQ(codes.size(), orderings);
    EXPECT_EQ(orders.size(), orderings);
  }
}

TEST_P(Conformance, GivesTheVerticesOfAFacetInTheOrderOfItsDart) {
  for (const Dart f : simplices_of(*mesh_, d_)) {
    std::vector<Index> v(4);
    mesh_->facet_vertices(mesh_->facet(f), v.data());
    v.resize(static_cast<std::size_t>(d_) + 1);
    EXPECT_EQ(v, vertices(mesh_->dart_of(d_, mesh_->facet(f)), d_));
  }
}

TEST_P(Conformance, SwitchChangesOnlyItsOwnSimplexAndIsAnInvolution) {
  for (const Dart d : all_darts(*mesh_))
    for (int k = 0; k <= d_; ++k) {
      const Dart other = mesh_->switch_dart(d, k);
      if (other == no_dart) {
        EXPECT_EQ(k, d_);
        EXPECT_TRUE(d_ == 0 || mesh_->is_boundary(d, d_ - 1));
        continue;
      }
      ASSERT_TRUE(mesh_->is_dart(other));
      EXPECT_EQ(mesh_->switch_dart(other, k), d);
      for (int j = 0; j <= d_; ++j) EXPECT_EQ(mesh_->simplex(other, j) == mesh_->simplex(d, j), j != k);
    }
}

TEST_P(Conformance, DistantSwitchesCommute) {
  for (const Dart d : all_darts(*mesh_))
    for (int i = 0; i <= d_; ++i)
      for (int j = i + 2; j <= d_; ++j) {
        const Dart across = mesh_->switch_dart(d, j);
        const Dart first = mesh_->switch_dart(mesh_->switch_dart(d, i), j);
        EXPECT_EQ(first, across == no_dart ? no_dart : mesh_->switch_dart(across, i));
      }
}

TEST_P(Conformance, ReorderIsAPermutationOfTheVertices) {
  for (const Dart d : all_darts(*mesh_)) {
    const auto v = vertices(d, d_);
    for (std::uint8_t code = 0; code < number_of_orders(d_); ++code) {
      const Permutation p{code};
      const auto w = vertices(mesh_->reorder(d, p), d_);
      for (std::size_t i = 0; i < w.size(); ++i)
        EXPECT_EQ(w[i], v[static_cast<std::size_t>(p[static_cast<int>(i)])]);
      EXPECT_EQ(mesh_->order(d, mesh_->reorder(d, p)), p);
      for (std::uint8_t next = 0; next < number_of_orders(d_); ++next)
        EXPECT_EQ(mesh_->reorder(mesh_->reorder(d, p), {next}), mesh_->reorder(d, then(p, {next})));
    }
    for (int k = 0; k < d_; ++k) EXPECT_EQ(mesh_->reorder(d, transposition(k)), mesh_->switch_dart(d, k));
  }
}

TEST_P(Conformance, SimplicesAndTheirDartsCorrespond) {
  for (int k = 0; k <= d_; ++k) {
    std::map<oracle::Simplex, Index> by_vertices;
    for (const Dart d : all_darts(*mesh_)) {
      const Index s = mesh_->simplex(d, k);
      ASSERT_LT(s, mesh_->capacity(k));
      EXPECT_TRUE(mesh_->is_live(k, s));
      EXPECT_EQ(mesh_->simplex(mesh_->dart_of(k, s), k), s);
      const auto [known, is_new] = by_vertices.try_emplace(simplex(d, k), s);
      EXPECT_EQ(known->second, s) << "a simplex is determined by its vertices";
    }
    std::size_t live = 0;
    for (Index s = 0; s < mesh_->capacity(k); ++s) live += mesh_->is_live(k, s);
    EXPECT_EQ(live, by_vertices.size());
    EXPECT_EQ(live, oracle::simplices(complex_of(*mesh_), k).size());
    EXPECT_FALSE(mesh_->is_live(k, mesh_->capacity(k)));
  }
  EXPECT_FALSE(mesh_->is_dart(no_dart));
}

TEST_P(Conformance, DartsOfDeadFacetsAreDead) {
  std::set<std::uint32_t> live;
  for (const Dart d : all_darts(*mesh_)) live.insert(code(d));
  const std::uint32_t codes = (d_ == 3   ? 32 * mesh_->capacity(3)
                               : d_ == 0 ? mesh_->capacity(0)
                                         : 4 * mesh_->capacity(1)) +
                              64;
  for (std::uint32_t c = 0; c < codes; ++c) EXPECT_EQ(mesh_->is_dart(Dart{c}), live.contains(c)) << c;
}

TEST_P(Conformance, StarIsThatOfTheVertexSets) {
  const auto all = oracle::simplices(complex_of(*mesh_));
  DartBuffer star;
  for (const Dart d : all_darts(*mesh_))
    for (int k = 0; k <= d_; ++k) {
      mesh_->star(d, k, star);
      oracle::SimplexSet found;
      for (const Dart t : star) {
        EXPECT_EQ(vertices(t, k), vertices(d, k)) << "keeps the first vertices, in order";
        found.push_back(simplex(t, d_));
      }
      const std::size_t darts = found.size();
      oracle::normalize(found);
      EXPECT_EQ(found.size(), darts) << "each facet once";
      EXPECT_EQ(found, oracle::of_dimension(oracle::star(all, simplex(d, k)), d_));
    }
}

TEST_P(Conformance, LinkIsThatOfTheVertexSets) {
  const auto all = oracle::simplices(complex_of(*mesh_));
  DartBuffer star;
  for (const Dart d : all_darts(*mesh_))
    for (int k = 0; k < d_; ++k) {
      mesh_->star(d, k, star);
      oracle::SimplexSet found;  // faces opposite the simplex, of all dimensions
      for (const Dart t : star)
        for (int j = k + 1; j <= d_; ++j)
          for (const Permutation p : faces_around(d_, j, k))
            found.push_back(oracle::minus(simplex(mesh_->reorder(t, p), j), simplex(d, k)));
      oracle::normalize(found);
      EXPECT_EQ(found, oracle::link(all, simplex(d, k)));
    }
}

TEST_P(Conformance, BoundaryIsThatOfTheVertexSets) {
  const auto rim = oracle::boundary(complex_of(*mesh_));
  for (const Dart d : all_darts(*mesh_))
    for (int k = 0; k < d_; ++k)
      EXPECT_EQ(mesh_->is_boundary(d, k), oracle::contains(rim, simplex(d, k))) << "dart " << code(d);
}

TEST_P(Conformance, RemovesTheListsOfValuesThatItKeeps) {
  const std::vector<std::string> foreign;
  for (const int k : {0, d_}) {
    EXPECT_THROW(mesh_->remove_values(k, foreign), UsageError);
    std::vector<std::string>* first = nullptr;
    try {
      first = &mesh_->add_values<std::string>(k, "first");
    } catch (const UsageError&) {
      continue;  // keeps none
    }
    std::vector<Index>& second = mesh_->add_values<Index>(k, "second");
    for (Index i = 0; i < second.size(); ++i) second[i] = i;
    const std::vector<Index> before = second;
    mesh_->remove_values(k, *first);
    EXPECT_EQ(second, before);
    EXPECT_THROW(mesh_->remove_values(k, foreign), UsageError);
    auto& again = mesh_->add_values<std::string>(k, "first");  // the name is free
    if (d_ > 0) shake(*mesh_, 7, 20);
    mesh_->forget();
    EXPECT_EQ(second.size(), mesh_->capacity(k));
    EXPECT_EQ(again.size(), mesh_->capacity(k));
    mesh_->remove_values(k, second);
    mesh_->remove_values(k, again);
    std::vector<std::string> problems;
    mesh_->check(problems);
    EXPECT_EQ(problems, std::vector<std::string>{});
  }
}

TEST_P(Conformance, RemovesNoValuesInsideATransaction) {
  std::vector<Index>* values = nullptr;
  try {
    values = &mesh_->add_values<Index>(0, "value");
  } catch (const UsageError&) {
    return;  // keeps none
  }
  const Mesh::Mark start = mesh_->mark();
  mesh_->protect(0, mesh_->vertex(simplices_of(*mesh_, d_).front()));
  if (mesh_->mark() == start) return;
  EXPECT_THROW(mesh_->remove_values(0, *values), UsageError);
  mesh_->rollback(start);
  mesh_->forget();
  mesh_->remove_values(0, *values);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Conformance, testing::ValuesIn(mesh_cases()),
                         [](const auto& mesh_case) { return mesh_case.param.name; });

TEST(FacesAround, ListsEachFaceOfAFacetOnce) {
  for (int d = 0; d <= 3; ++d)
    for (int j = 0; j <= d; ++j)
      for (int k = -1; k <= j; ++k) {
        std::set<std::set<int>> faces;
        for (const Permutation p : faces_around(d, j, k)) {
          std::set<int> face;
          for (int i = 0; i <= j; ++i) face.insert(p[i]);
          for (int i = 0; i <= k; ++i) EXPECT_EQ(p[i], i);
          for (int i = 0; i <= j; ++i) EXPECT_LE(p[i], d);
          EXPECT_TRUE(faces.insert(face).second);
        }
        const auto choose = [](int n, int m) {
          return m == 0 || m == n ? 1U : m == 1 || m == n - 1 ? unsigned(n) : 6U;
        };
        EXPECT_EQ(faces.size(), choose(d - k, j - k)) << d << j << k;
      }
}

TEST(Permutations, FormTheSymmetricGroup) {
  for (std::uint8_t c = 0; c < 24; ++c) {
    const Permutation p{c};
    EXPECT_EQ(permutation(p[0], p[1], p[2], p[3]), p);
    EXPECT_EQ(then(p, inverse(p)).code, 0);
    EXPECT_EQ(then(inverse(p), p).code, 0);
    EXPECT_EQ(p[2] == 2 && p[3] == 3, c < 2);
    EXPECT_EQ(p[3] == 3, c < 6);
  }
}

}  // namespace
}  // namespace multimesh::test
