// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/domain_report.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// {"tetrahedra": .., "regions": [..], "surface": .., "patches": [..], "curves": .., "curve_tags": [..],
/// "fixed_points": .., "fixed_point_tags": [..], "quality": ..}; surface and curves are null where there is
/// none.
Json to_json(const DomainReport& report);
/// The same in lines, to standard output.
void print_domain(const Json& j);

}  // namespace multimesh::tools
