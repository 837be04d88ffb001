// SPDX-License-Identifier: BSD-3-Clause
#include "tools/help_format.hpp"

#include <algorithm>

namespace multimesh::tools {

std::string HelpFormat::options_of(const CLI::App& app, const std::string& group) const {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group && option->nonpositional() &&
        !(app.get_name().empty() && option == app.get_help_ptr()))
      text += make_option(option, false);
  return text;
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  if (app->get_parent() == nullptr || app->get_name().empty()) return Formatter::make_help(app, name, mode);
  std::string text = app->get_description() + "\n" + make_usage(app, name) + make_positionals(app);
  // Groups of options of which some are required.
  for (const CLI::App* needed : app->get_subcommands({}))
    text +=
        "\n" + needed->get_group() + ": " + needed->get_description() + "\n" + options_of(*needed, "Options");
  std::vector<std::string> groups = app->get_groups();
  std::ranges::stable_partition(groups, [](const std::string& group) { return group == "Targets"; });
  for (const std::string& group : groups)
    if (const std::string options = options_of(*app, group); !group.empty() && !options.empty())
      text += "\n" + group + ":\n" + options;
  return text + "\n" + make_footer(app);
}

}  // namespace multimesh::tools
