// SPDX-License-Identifier: BSD-3-Clause
#include "tools/option_values.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace multimesh::tools {

namespace {

template <class Number>
bool is_number(const std::string& text, Number& x) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, x);
  return error == std::errc() && stop == end;
}

Json value_of(const std::string& text) {
  std::int64_t whole{};
  double number{};
  if (is_number(text, whole)) return whole;
  if (is_number(text, number) && std::isfinite(number)) return number;
  return text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

Json given_value(const CLI::Option& option, const std::string& name) {
  const auto& given = option.results();
  const bool is_flag = option.get_expected_max() == 0;
  // For `!--no-weld`, the value is that of the option that it turns off.
  if (is_flag) return (given.back() == "true") != contains(option.get_fnames(), name);
  if (option.get_expected_max() == 1) return value_of(given.back());
  Json list = Json::array();
  for (const std::string& text : given) list.push_back(value_of(text));
  return list;
}

void add_values(const CLI::App& command, Json& values) {
  constexpr std::array left_out = {"help", "output", "report", "report-html", "json"};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_lnames().empty()) continue;
    std::string name = option->get_lnames().front();
    if (std::ranges::find(left_out, name) != left_out.end()) continue;
    Json value = option->count() > 0                 ? given_value(*option, name)
                 : option->get_default_str().empty() ? Json()
                                                     : value_of(option->get_default_str());
    std::ranges::replace(name, '-', '_');
    if (!value.is_null()) values[name] = std::move(value);
  }
  for (const CLI::App* group : command.get_subcommands({})) add_values(*group, values);
}

}  // namespace

Json option_values(const CLI::App& command) {
  Json values = Json::object();
  add_values(command, values);
  return values;
}

}  // namespace multimesh::tools
