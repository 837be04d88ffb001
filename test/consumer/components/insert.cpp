// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  using namespace multimesh;
  const BackgroundMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {3, 4, {0, 1, 2, 3}}, {0, 1, 2}};
  const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {2, 3, {0, 1, 2}}};
  return insert(soup, one).faces.size() == 1;
}
