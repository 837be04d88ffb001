// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "multimesh/files/domain_file.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace multimesh::tools {

/// How files of simplices are written.
struct SimplexFormat {
  bool ascii = false, msh_2 = false;
  int order = 1;

  io::SimplexWriteOptions options() const {
    return {
        .msh_version = msh_2 ? io::MshVersion::v2_2 : io::MshVersion::v4_1, .binary = !ascii, .order = order};
  }
};

/// Each adds options; what they set must live as long as the command.
/// --weld and --no-weld.
void add_weld_options(CLI::App& command, files::DomainReadOptions& options);
/// --no-periodic.
CLI::Option* add_periodic_option(CLI::App& command, bool& no_periodic);
/// --ascii, --msh2 and --order.
void add_format_options(CLI::App& command, SimplexFormat& format, const std::string& group = "Options");

}  // namespace multimesh::tools
