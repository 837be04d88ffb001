// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

enum ExitCode : int { done = 0, refused = 1, usage = 2 };

/// Each adds its subcommand, and sets `exit_code` when it has run.
void add_compare_command(CLI::App& app, int& exit_code);
void add_decimate_command(CLI::App& app, int& exit_code);
/// In a build without multimesh::improve, the command only says that it is missing.
void add_improve_command(CLI::App& app, int& exit_code);
/// In a build without TetGen or GMP, the command only says that it is missing.
void add_insert_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_remesh_command(CLI::App& app, int& exit_code);
/// In a build without TetGen, the command only says that it is missing.
void add_tetrahedralize_command(CLI::App& app, int& exit_code);
void add_validate_command(CLI::App& app, int& exit_code);

}  // namespace multimesh::tools
