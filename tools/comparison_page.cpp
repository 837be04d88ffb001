// SPDX-License-Identifier: BSD-3-Clause
#include "tools/comparison_page.hpp"

#include "tools/comparison_json.hpp"
#include "tools/html_report.hpp"

namespace multimesh::tools {

std::vector<std::string> write_comparison_page(const std::filesystem::path& path, const std::string& title,
                                               HtmlMesh before, HtmlMesh after, SurfaceComparison comparison,
                                               Json numbers) {
  const Json measured = to_json(comparison);
  numbers["comparison"] = {{"diagonal", measured["diagonal"]},
                           {"distance", measured["distance"]},
                           {"texture", measured["texture"]}};
  HtmlReport report{.title = title,
                    .before = std::move(before),
                    .after = std::move(after),
                    .errors = {},
                    .numbers = std::move(numbers)};
  report.errors.push_back({"Distance", std::move(comparison.vertex_distance)});
  if (comparison.texture)
    report.errors.push_back({"Texture deviation", std::move(comparison.vertex_deviation)});
  return write_html_report(path, report);
}

}  // namespace multimesh::tools
