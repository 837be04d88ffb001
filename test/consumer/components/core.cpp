// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  const multimesh::FacetList bow_tie{2, 5, {0, 1, 2, 0, 3, 4}};
  return multimesh::cut(bow_tie).facets.vertices == 6;
}
