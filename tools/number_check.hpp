// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace multimesh::tools {

/// Requires that an option's value is a number for which `holds`; otherwise the message says what it must be.
/// `type`: the name of the value in the help.
inline CLI::Validator number(bool (*holds)(double), const std::string& must_be, const std::string& type) {
  const auto check = [=](std::string& s) {
    double x = 0;
    return CLI::detail::lexical_cast(s, x) && holds(x) ? std::string() : "must be " + must_be;
  };
  return CLI::Validator(check, type);
}

inline CLI::Validator positive_number() {
  return number([](double x) { return x > 0; }, "above 0", "NUMBER");
}

}  // namespace multimesh::tools
