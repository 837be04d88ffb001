// SPDX-License-Identifier: BSD-3-Clause
#include "tools/comparison_page.hpp"

#include <nlohmann/json.hpp>

#include "tools/comparison_json.hpp"

namespace multimesh::tools {

HtmlReport comparison_page(const std::string& title, HtmlMesh before, HtmlMesh after,
                           SurfaceComparison comparison, Json numbers) {
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
  return report;
}

}  // namespace multimesh::tools
