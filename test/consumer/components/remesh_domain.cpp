// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  multimesh::TaggedTetrahedra input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {3, 4, {0, 1, 2, 3}};
  multimesh::TetDomain domain(input);
  multimesh::DomainRemeshOptions options;
  options.length = 0.5;
  return multimesh::remesh(domain, options).surface.splits > 0;
}
