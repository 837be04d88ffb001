// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tools/surface_json.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

struct HtmlReport;

/// Where the reports of a run are written; empty: there is none.
struct ReportOptions {
  std::string json;  ///< "-" is standard output
  std::string html;
};

/// Adds --report and --report-html. `page`: what the latter shows.
void add_report_options(CLI::App& command, ReportOptions& options, const std::string& page);
/// Adds the old --json, hidden: as a flag that prints the report, or with the file's name.
void add_old_json_flag(CLI::App& command, ReportOptions& options);
void add_old_json_file(CLI::App& command, ReportOptions& options);

/// What a command reports about its run: warnings on standard error, and the same in the reports. Every
/// report has `command`, `version`, `inputs`, `outputs`, `options`, `warnings` and `seconds`; docs/report.md.
class RunReport {
 public:
  using Paths = std::vector<std::string>;

  /// Create it before the work. \throw InputError if a report cannot be written, or would replace a file of
  /// this run
  RunReport(const CLI::App& command, ReportOptions options, Paths inputs, Paths outputs = {});
  ~RunReport();

  bool wanted() const { return !options_.json.empty() || wants_page(); }
  bool wants_page() const { return !options_.html.empty(); }
  /// If so, nothing else may be printed there.
  bool is_printed() const { return options_.json == "-"; }
  /// Since its construction.
  double seconds() const;

  /// The command's own fields; may have `seconds`, and more `options`.
  Json& json() { return *json_; }
  /// The page. The common fields of all reports are added to its numbers.
  void show(HtmlReport page);

  /// Writes the reports. Prints the warnings unless `quiet`, and what is left out of the page.
  /// \throw InputError
  void finish(std::vector<std::string> warnings, bool quiet = false);

 private:
  void add_common(Json& j) const;
  void write_page(std::vector<std::string>& warnings);
  void write_json(const std::vector<std::string>& warnings) const;

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const CLI::App& command_;
  ReportOptions options_;
  Paths inputs_, outputs_;
  std::unique_ptr<Json> json_;
  std::unique_ptr<HtmlReport> page_;
};

}  // namespace multimesh::tools
