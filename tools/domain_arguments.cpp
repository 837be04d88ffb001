// SPDX-License-Identifier: BSD-3-Clause
#include "tools/domain_arguments.hpp"

#include <CLI/CLI.hpp>

#include "tools/number_check.hpp"

namespace multimesh::tools {

void add_weld_options(CLI::App& command, files::DomainReadOptions& options) {
  auto* weld = command.add_option("--weld", options.weld,
                                  "join points at most this far apart; 0: only those at one place");
  weld->check(number([](double x) { return x >= 0; }, "0 or more", "DISTANCE"));
  command.add_flag("--no-weld", options.no_weld, "do not warn of points at one place")->excludes(weld);
}

CLI::Option* add_periodic_option(CLI::App& command, bool& no_periodic) {
  return command.add_flag("--no-periodic", no_periodic,
                          "treat a periodic mesh as any other; its sides need not match afterwards");
}

void add_format_options(CLI::App& command, SimplexFormat& format, const std::string& group) {
  command.add_flag("--ascii", format.ascii, "text instead of binary, where the format has both")
      ->group(group);
  command.add_flag("--msh2", format.msh_2, "MSH 2.2 instead of 4.1")->group(group);
  command
      .add_option("--order", format.order,
                  "2: elements of second order, with a node in the middle of each edge")
      ->check(CLI::IsMember(std::vector<int>{1, 2}))
      ->capture_default_str()
      ->group(group);
}

}  // namespace multimesh::tools
