// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/texture_loss.hpp"
#include "tools/decimate_arguments.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

const char* to_string(DecimateResult::Stop stop);
/// Whether all given target numbers of faces were reached.
bool target_reached(const DecimateOptions& o, const DecimateResult& r);

/// A sentence if the target was missed, and why. `faces`: of what.
void warn_of_target(const DecimateOptions& o, const DecimateResult& r, const char* faces,
                    std::vector<std::string>& warnings);

/// What was requested and what was done; docs/decimation.md has the fields.
Json decimation_json(const DecimateArguments& a, const DecimateOptions& o, const DecimateResult& r);

/// For the reports, and as a warning.
Json to_json(const TextureLoss& loss);
std::string in_words(const TextureLoss& loss, const DecimateResult& result);

}  // namespace multimesh::tools
