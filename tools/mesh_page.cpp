// SPDX-License-Identifier: BSD-3-Clause
#include "tools/mesh_page.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace multimesh::tools {

namespace {

std::string name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

void show_mesh(RunReport& report, HtmlMesh mesh, const std::string& path) {
  HtmlReport page;
  page.title = name(path);
  page.after = std::move(mesh);
  page.after.caption = page.title;
  page.numbers = report.json();
  report.show(std::move(page));
}

void show_domains(RunReport& report, HtmlMesh before, const TetDomain& after, const std::string& input,
                  const std::string& output) {
  HtmlReport page;
  page.title = name(input);
  page.before = std::move(before);
  page.before.caption = name(input);
  page.after = html_mesh(after);
  page.after.caption = name(output);
  page.numbers = report.json();
  report.show(std::move(page));
}

}  // namespace multimesh::tools
