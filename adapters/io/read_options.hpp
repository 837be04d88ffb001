// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace multimesh::io {

/// How much of a file may be defective before it is refused. A few such faces are normal in large models
/// (they are left out or kept, and counted in a warning); a file made of them is a broken file. 0 refuses
/// the first one, 1 accepts all.
struct ReadOptions {
  /// Largest share of faces with fewer than three distinct vertices. They cannot be kept in any mesh.
  double max_collapsed_share = 0.01;
  /// Largest share of faces that have no area or repeat the vertices of an earlier face. They are kept; but
  /// where most faces are repeated every edge has three or more faces, and no surface is left to work on.
  double max_defective_share = 1.0 / 3.0;
  /// Keep the `l` statements of OBJ files as polylines of the soup; a file with lines and no face is then
  /// read, too. Otherwise they are counted and left out.
  bool keep_lines = false;
};

}  // namespace multimesh::io
