// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "multimesh/algorithms/compare.hpp"
#include "tools/html_report.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// A page that shows two surfaces side by side, with the errors of `comparison` per vertex, which it must
/// have. Shows `numbers`, together with those of the comparison.
HtmlReport comparison_page(const std::string& title, HtmlMesh before, HtmlMesh after,
                           SurfaceComparison comparison, Json numbers);

}  // namespace multimesh::tools
