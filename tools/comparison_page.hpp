// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "multimesh/algorithms/compare.hpp"
#include "tools/html_mesh.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// Writes a page that shows two surfaces side by side, with the errors of `comparison` per vertex, which it
/// must have. `numbers` are shown, with those of the comparison. \return the notes on the page. \throw
/// InputError as write_html_report
std::vector<std::string> write_comparison_page(const std::filesystem::path& path, const std::string& title,
                                               HtmlMesh before, HtmlMesh after, SurfaceComparison comparison,
                                               Json numbers);

}  // namespace multimesh::tools
