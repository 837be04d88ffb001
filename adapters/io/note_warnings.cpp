// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/note_warnings.hpp"

namespace multimesh::io {

void add_note_warnings(PolygonSoup& soup, const std::string& file) {
  const auto warn = [&](std::size_t count, const char* before, const char* after) {
    if (count == 0) return;
    std::string warning = file;
    warning.append(": ").append(before).append(std::to_string(count)).append(after);
    soup.warnings.push_back(std::move(warning));
  };
  const SoupNotes& n = soup.notes;
  const std::size_t lines_left_out = n.lines - soup.line_count();
  warn(n.points + lines_left_out + n.curves, "", " point, line and curve statements are left out");
  warn(n.third_texcoords, "the third number of ", " texture coordinates is left out");
  warn(n.weights, "the weight or alpha of ", " vertices is left out");
  warn(n.missing_colors, "vertices without a colour, white now: ", "");
  warn(n.nonfinite_normals, "normals that were not finite (nan, inf) are 0 0 0 now: ", "");
}

}  // namespace multimesh::io
