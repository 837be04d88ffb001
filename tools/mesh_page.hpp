// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/html_report.hpp"
#include "tools/run_report.hpp"

namespace multimesh::tools {

// Each uses the numbers that the report has so far.

/// Shows one mesh.
void show_mesh(RunReport& report, HtmlMesh mesh, const std::string& path);
/// Shows the surfaces of tetrahedra before and after a run.
void show_domains(RunReport& report, HtmlMesh before, const TetDomain& after, const std::string& input,
                  const std::string& output);

}  // namespace multimesh::tools
