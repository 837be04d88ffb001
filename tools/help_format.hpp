// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace multimesh::tools {

/// Help of a command: its targets come first, then its other options by groups.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 private:
  std::string options_of(const CLI::App& app, const std::string& group) const;
};

}  // namespace multimesh::tools
