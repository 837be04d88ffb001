// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/materials.hpp"
#include "multimesh/files/surface_file.hpp"

namespace multimesh::tools {

/// A mesh as a report shows it.
struct HtmlMesh {
  std::string caption = {};                     ///< its file name, for instance
  TexturedTriangles surface = {};               ///< labels are ignored
  std::vector<files::Material> materials = {};  ///< those in use
  std::vector<Index> material = {};             ///< per triangle, into materials; empty: the first for all
  std::vector<std::string> notes = {};          ///< what could not be shown as in the file
};

/// A file with its materials.
HtmlMesh html_mesh(const files::SurfaceFile& file);

/// A surface made from a file: `source` is the triangle of `file.input` from which each triangle of `surface`
/// comes, as returned by TexturedSurface::triangles. The caller sets the caption.
HtmlMesh html_mesh(TexturedTriangles surface, const std::vector<Index>& source,
                   const files::SurfaceFile& file);

/// The surface of tetrahedra, with a material for each patch. The caller sets the caption.
HtmlMesh html_mesh(const TetDomain& domain);

}  // namespace multimesh::tools
