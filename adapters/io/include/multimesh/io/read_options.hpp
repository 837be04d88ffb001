// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace multimesh::io {

/// What a reader keeps of a file.
struct ReadOptions {
  /// Largest accepted share of simplices that name a point twice (these are left out) in a file of simplices.
  /// 0 refuses the first one.
  double max_collapsed_share = 1;
  /// Keep faces with the vertices of an earlier one, in any order: where two solids meet, each may
  /// list the face between them. Otherwise they are left out, if they have the same texture and
  /// material.
  bool keep_repeated = false;
  /// Keep the `l` statements of OBJ files as polylines of the soup; a file with lines but no face is then
  /// also read. Otherwise they are counted and left out.
  bool keep_lines = false;
};

}  // namespace multimesh::io
