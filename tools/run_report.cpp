// SPDX-License-Identifier: BSD-3-Clause
#include "tools/run_report.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "adapters/io/atomic_file.hpp"
#include "multimesh/error.hpp"
#include "multimesh/version.hpp"
#include "tools/html_report.hpp"
#include "tools/option_values.hpp"
#include "tools/output_check.hpp"

namespace multimesh::tools {

void add_report_options(CLI::App& command, ReportOptions& options, const std::string& page) {
  command.add_option("--report", options.json, "write a JSON report; -: to standard output")
      ->type_name("FILE")
      ->group("Reports");
  command.add_option("--report-html", options.html, "write an HTML page " + page)
      ->type_name("FILE")
      ->group("Reports");
}

void add_old_json_flag(CLI::App& command, ReportOptions& options) {
  command
      .add_flag_callback(
          "--json", [&options] { options.json = "-"; }, "as --report -")
      ->group("");
}

void add_old_json_file(CLI::App& command, ReportOptions& options) {
  command.add_option("--json", options.json, "as --report")->group("");
}

RunReport::RunReport(const CLI::App& command, ReportOptions options, Paths inputs, Paths outputs)
    : command_(command),
      options_(std::move(options)),
      inputs_(std::move(inputs)),
      outputs_(std::move(outputs)),
      json_(std::make_unique<Json>(Json::object())) {
  std::vector<std::filesystem::path> others(inputs_.begin(), inputs_.end());
  others.insert(others.end(), outputs_.begin(), outputs_.end());
  if (!options_.json.empty() && !is_printed()) check_output_path(options_.json, others);
  if (!wants_page()) return;
  require_html_report();
  check_output_path(options_.html, others);
  if (options_.html == options_.json)
    throw InputError(options_.html + ": both reports would have this name; choose another one");
}

RunReport::~RunReport() = default;

double RunReport::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RunReport::show(HtmlReport page) {
  page_ = std::make_unique<HtmlReport>(std::move(page));
}

void RunReport::add_common(Json& j) const {
  j["command"] = command_.get_name();
  j["version"] = version;
  j["inputs"] = inputs_;
  j["outputs"] = outputs_;
  j["options"] = option_values(command_);
}

void RunReport::write_page(std::vector<std::string>& warnings) {
  Json numbers = Json::object();
  add_common(numbers);
  if (page_->numbers.contains("options")) numbers["options"].update(page_->numbers["options"]);
  page_->numbers.erase("options");
  numbers.update(page_->numbers);
  if (!numbers.contains("seconds")) numbers["seconds"] = seconds();
  numbers["warnings"] = warnings;
  page_->numbers = std::move(numbers);
  for (const std::string& note : write_html_report(options_.html, *page_))
    if (std::ranges::find(warnings, note) == warnings.end()) warnings.push_back(note);
}

void RunReport::write_json(const std::vector<std::string>& warnings) const {
  Json j = Json::object(), own = *json_;
  add_common(j);
  if (own.contains("options")) j["options"].update(own["options"]);
  own.erase("options");
  j.update(own);
  if (!j.contains("seconds")) j["seconds"] = seconds();
  j["warnings"] = warnings;
  if (is_printed()) {
    std::cout << to_text(j);
  } else {
    io::AtomicFile file(options_.json);
    file.write(to_text(j));
    file.commit();
  }
}

void RunReport::finish(std::vector<std::string> warnings, bool quiet) {
  if (page_ && wants_page()) write_page(warnings);
  if (!options_.json.empty()) write_json(warnings);
  if (!std::cout.flush()) throw InputError("standard output: writing failed");
  if (quiet) return;
  for (const std::string& w : warnings) std::cerr << "warning: " << w << '\n';
}

}  // namespace multimesh::tools
