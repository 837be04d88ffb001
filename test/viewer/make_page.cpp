// SPDX-License-Identifier: BSD-3-Clause
// make_page OUT.html BEFORE AFTER [REPORT.json]: a report of two files, for the tests of the page.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tools/html_report.hpp"

namespace {

using namespace multimesh;
using namespace multimesh::tools;

/// An error to look at: it grows along an axis.
HtmlError made_up_error(const std::string& name, const TexturedTriangles& after, std::size_t axis) {
  HtmlError error{name, {}};
  for (const auto& p : after.positions) error.values.push_back(0.01 * std::abs(p[axis]));
  return error;
}

int make_page(int argc, char** argv) {
  const files::SurfaceFile before = files::read_surface(argv[2]);
  // Its textures are those beside the file that it was made from.
  const files::SurfaceFile after = files::read_surface(argv[3], {.follow_paths = true});
  HtmlReport report{.title = before.path.filename().string() + " → " + after.path.filename().string(),
                    .before = html_mesh(before),
                    .after = html_mesh(after)};
  report.errors = {made_up_error("Distance", report.after.surface, 0),
                   made_up_error("Texture deviation", report.after.surface, 1)};
  if (argc > 4) {
    std::ifstream in(argv[4]);
    report.numbers = Json::parse(in);
  } else {
    report.numbers = {{"before", to_json(TexturedSurface(before.input))},
                      {"after", to_json(TexturedSurface(after.input))},
                      {"warnings", after.warnings}};
  }
  write_html_report(argv[1], report);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 4 || argc == 5) return make_page(argc, argv);
    std::cerr << "usage: make_page OUT.html BEFORE AFTER [REPORT.json]\n";
    return 2;
  } catch (const std::exception& e) {
    std::cerr << "make_page: " << e.what() << '\n';
    return 1;
  }
}
