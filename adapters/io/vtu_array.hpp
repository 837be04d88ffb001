// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pugi {
class xml_node;
}

namespace multimesh::io {

/// Decodes the `DataArray` elements of one VTK XML file: text, base64 and raw bytes, inline and appended,
/// plain and compressed by zlib. Every error is an InputError naming the file and the array.
class VtuArrays {
 public:
  /// `root` is the element VTKFile; `xml` the text of the file, `appended` what follows the `_` of
  /// AppendedData.
  VtuArrays(const pugi::xml_node& root, std::string_view xml, std::string_view appended,
            const std::string& file);

  std::vector<double> reals(const pugi::xml_node& array) const;
  /// \throw InputError also for values that are not integers
  std::vector<std::int64_t> integers(const pugi::xml_node& array) const;
  static bool holds_integers(const pugi::xml_node& array);

  [[noreturn]] void fail(const pugi::xml_node& array, const std::string& message) const;

 private:
  template <class T>
  std::vector<T> values(const pugi::xml_node& array) const;
  template <class T>
  std::vector<T> text_values(const pugi::xml_node& array) const;
  std::string bytes(const pugi::xml_node& array) const;
  std::string unpacked(const pugi::xml_node& array, std::string_view data) const;
  std::string inflated(const pugi::xml_node& array, std::string_view data) const;
  std::uint64_t header_number(const pugi::xml_node& array, std::string_view& data) const;

  std::string_view xml_, appended_;
  std::string file_;
  bool appended_is_base64_ = false;
  bool compressed_ = false;
  bool swap_ = false;
  bool wide_header_ = false;  ///< sizes have 8 bytes, not 4
};

}  // namespace multimesh::io
