// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// The textures of a page: each file once, however many materials use it.
class HtmlTextures {
 public:
  /// `limit`: bytes of all data URIs together.
  explicit HtmlTextures(std::size_t limit) : limit_(limit) {}

  /// Its number. A file that cannot be shown also has one, with an empty URI and, unless it is missing (see
  /// read_materials), a note.
  std::size_t number(const std::filesystem::path& file);

  Json names() const { return names_; }  ///< [{"name": ..}]
  const std::vector<std::string>& uris() const { return uris_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::size_t limit_, size_ = 0;
  std::map<std::filesystem::path, std::size_t> numbers_;
  Json names_ = Json::array();
  std::vector<std::string> uris_, notes_;
};

}  // namespace multimesh::tools
