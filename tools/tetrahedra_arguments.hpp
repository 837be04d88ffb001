// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/improve.hpp"
#include "multimesh/io/weld_surface.hpp"
#include "tools/domain_arguments.hpp"

namespace multimesh::tools {

/// What commands for surfaces are told beside that, where the surface is that of tetrahedra.
struct TetrahedraArguments {
  bool weld_given = false, uv_weld_given = false, target_given = false;
  double target_amips = 10;
  std::vector<std::string> locked_patches;
  std::vector<TetDomain::Tag> locked_regions;
  bool no_periodic = false;
  SimplexFormat format;
};

void add_tetrahedra_options(CLI::App& command, TetrahedraArguments& a);

/// Refuses what only one kind of input has a use for, by name, in the name of a file that is of the other
/// one.
struct OptionCheck {
  std::string input;
  bool tetrahedra = false;

  /// \throw InputError if it was given
  void refuse(bool given, const char* option) const;
  /// Those of TetrahedraArguments, for a surface.
  void refuse_tetrahedra_options(const TetrahedraArguments& a) const;
};

/// Reads a file that may have tetrahedra. \return nothing if it has none
std::optional<files::DomainFile> read_tetrahedra(const std::string& input, const TetrahedraArguments& a,
                                                 const io::SurfaceWeldOptions& weld);

// Sentences about what has changed that should not. `remedy`: what keeps it better.
void warn_of_tetrahedra(const ImproveResult& result, double target, std::vector<std::string>& warnings);
void warn_of_contact(const TaggedTetrahedra& lists, const std::string& remedy,
                     std::vector<std::string>& warnings);

}  // namespace multimesh::tools
