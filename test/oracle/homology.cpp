// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/homology.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace multimesh::oracle {

namespace {

/// A column of the boundary matrix: its rows with a 1, ascending.
using Column = std::vector<std::size_t>;

Column sum(const Column& a, const Column& b) {
  Column c;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(c));
  return c;
}

Column boundary_of(const Simplex& s, const SimplexSet& cells) {
  Column rows;
  if (s.n == 1) return rows;
  for (int i = 0; i < s.n; ++i) {
    const Simplex side = minus(s, simplex({s.v[static_cast<std::size_t>(i)]}));
    const auto at = std::lower_bound(cells.begin(), cells.end(), side);
    if (at != cells.end() && *at == side) rows.push_back(static_cast<std::size_t>(at - cells.begin()));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// The chain complex that these cells span; sides that are not among them count as zero. They are sorted by
/// dimension, so that one elimination from left to right does all dimensions.
Betti ranks(const SimplexSet& cells) {
  Betti result{};
  std::vector<Column> with_last(cells.size());  // by last row: the reduced column that ends there
  for (const Simplex& s : cells) {
    Column column = boundary_of(s, cells);
    while (!column.empty() && !with_last[column.back()].empty())
      column = sum(column, with_last[column.back()]);
    const auto k = static_cast<std::size_t>(s.n - 1);
    if (column.empty()) {
      ++result[k];  // a cycle more
    } else {
      --result[k - 1];  // a cycle that bounds
      const std::size_t last = column.back();
      with_last[last] = std::move(column);
    }
  }
  return result;
}

}  // namespace

Betti betti(const SimplexSet& K) {
  return ranks(K);
}

Betti betti(const SimplexSet& K, const SimplexSet& A) {
  SimplexSet rest;
  std::set_difference(K.begin(), K.end(), A.begin(), A.end(), std::back_inserter(rest));
  return ranks(rest);
}

}  // namespace multimesh::oracle
