// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "adapters/io/word_source.hpp"

namespace multimesh::io {

/// The numbers of a Gmsh file one after the other, whether they are text or binary. Names of sections are
/// always text.
class MshSource {
 public:
  /// Reads $MeshFormat. \throw InputError for any version but 2.x and 4.1.
  MshSource(std::string_view bytes, const std::string& file);

  int version() const { return version_; }  ///< 2 or 4
  bool binary() const { return binary_; }

  /// The name of the next section without `$`. False at the end of the file.
  bool next_section(std::string& name);
  /// Requires `$EndNAME` at this place.
  void end_section(const std::string& name);
  /// Continues after `$EndNAME`.
  void skip_section(const std::string& name);

  /// Raw bytes begin on the next line, if the file is binary.
  void begin_data();
  /// `what` names the number in messages.
  std::int32_t integer(std::string_view what);  ///< 4 bytes
  std::uint64_t size(std::string_view what);    ///< 8 bytes
  double real(std::string_view what);           ///< 8 bytes
  /// The number of things that have so many numbers each. \throw InputError when the rest is too short.
  std::size_t count(std::string_view what, std::size_t numbers_each);

  /// The place of the last number, for SimplexBuilder: its line in a text file, otherwise `number`.
  std::uint64_t where(std::uint64_t number) const { return binary_ ? number : words_.line(); }
  WordSource& words() { return words_; }
  [[noreturn]] void fail(const std::string& message) const { words_.fail(message); }

 private:
  void read_format();

  WordSource words_;
  int version_ = 0;
  bool binary_ = false;
  bool swap_ = false;
};

}  // namespace multimesh::io
