// SPDX-License-Identifier: BSD-3-Clause
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <exception>
#include <iostream>

#include "adapters/io/atomic_file.hpp"
#include "multimesh/error.hpp"
#include "multimesh/version.hpp"
#include "tools/command.hpp"
#include "tools/help_format.hpp"

namespace {

/// Returns large buffers of one phase of the work before the next phase: without a fixed threshold, glibc
/// keeps them in its heap after the first one was freed.
void give_memory_back() {
#ifdef M_MMAP_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace multimesh;
  give_memory_back();
  io::install_signal_cleanup();
  CLI::App app{
      "Meshes that stay consistent: textured surfaces with their seams, tetrahedra with surfaces and "
      "curves inside."};
  app.name("multimesh");
  app.formatter(std::make_shared<tools::HelpFormat>());
  app.set_version_flag("--version", std::string("multimesh ") + version);
  app.require_subcommand(1);
  app.footer("See multimesh COMMAND --help. Exit status: 0 done, 1 refused or bad input, 2 wrong usage.");
  int exit_code = tools::done;
  tools::add_decimate_command(app, exit_code);
  tools::add_compare_command(app, exit_code);
  tools::add_improve_command(app, exit_code);
  tools::add_info_command(app, exit_code);
  tools::add_remesh_command(app, exit_code);
  tools::add_tetrahedralize_command(app, exit_code);
  tools::add_insert_command(app, exit_code);
  tools::add_validate_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? tools::done : tools::usage;
  } catch (const InputError& e) {
    std::cerr << "multimesh: " << e.what() << '\n';
    return tools::refused;
  } catch (const std::bad_alloc&) {
    std::cerr << "multimesh: out of memory\n";
    return tools::refused;
  } catch (const std::exception& e) {
    std::cerr << "multimesh: internal error: " << e.what() << '\n';
    return tools::refused;
  }
  return exit_code;
}
