// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_check.hpp"

#include <system_error>

#include "adapters/io/output_path.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::tools {

void check_output_path(const std::filesystem::path& output,
                       const std::vector<std::filesystem::path>& others) {
  (void)io::checked_output_path(output);
  std::error_code error;  // of a path that does not exist: it is no other file then
  const auto path = std::filesystem::weakly_canonical(output, error);
  for (const auto& other : others)
    if (path == std::filesystem::weakly_canonical(other, error))
      throw InputError(output.string() + ": would replace " + other.string() +
                       ", which this run reads or writes, too; choose another name");
}

void check_output_path(const std::filesystem::path& output, const std::vector<std::filesystem::path>& others,
                       const SimplexFormat& format) {
  check_output_path(output, others);
  io::check_simplex_output(output, format.options());
}

void check_surface_output(const std::filesystem::path& output) {
  check_output_path(output, {});
  if (!files::is_surface_format(output) || output.extension() == ".gz")
    throw InputError(output.string() +
                     ": only OBJ, PLY, OFF and STL files are written; give a name that ends in .obj");
}

}  // namespace multimesh::tools
