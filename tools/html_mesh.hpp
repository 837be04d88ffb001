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
  TexturedTriangles surface = {};               ///< labels are not looked at
  std::vector<files::Material> materials = {};  ///< those in use
  std::vector<Index> material = {};             ///< per triangle, into materials; empty: all of the first
  std::vector<std::string> notes = {};          ///< what could not be shown as the file has it
};

/// A file with its materials.
HtmlMesh html_mesh(const files::SurfaceFile& file);

/// What was made of a file: `source` is the triangle of `file.input` that each triangle of `surface` comes
/// from, as TexturedSurface::triangles gives it. The caption is the caller's to set.
HtmlMesh html_mesh(TexturedTriangles surface, const std::vector<Index>& source,
                   const files::SurfaceFile& file);

/// The surface of tetrahedra, with a material for each patch. The caption is the caller's to set.
HtmlMesh html_mesh(const TetDomain& domain);

}  // namespace multimesh::tools
