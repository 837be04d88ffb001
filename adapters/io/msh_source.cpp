// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/msh_source.hpp"

#include "adapters/io/byte_order.hpp"

namespace multimesh::io {

MshSource::MshSource(std::string_view bytes, const std::string& file) : words_(bytes, file) {
  read_format();
}

void MshSource::read_format() {
  const std::string_view first = words_.peek();
  if (first == "$NOD") fail("this is version 1 of Gmsh's format; save it with Gmsh as version 4.1 or 2.2");
  std::string section;
  while (next_section(section) && section != "MeshFormat") skip_section(section);
  if (section != "MeshFormat") fail("the file has no section $MeshFormat; save it with Gmsh again");
  const std::string version(words_.word("the version"));
  if (version.starts_with("2")) version_ = 2;
  if (version == "4.1") version_ = 4;
  if (version_ == 0)
    fail("version " + quoted_word(version) +
         " of Gmsh's format is not read; save it with Gmsh as version 4.1 or 2.2");
  const std::int64_t type = words_.integer("the file type");
  const std::int64_t data_size = words_.integer("the data size");
  if (type != 0 && type != 1) fail("the file type must be 0 (text) or 1 (binary); correct it");
  if (data_size != 8 && type == 1)
    fail("binary files with a data size of " + std::to_string(data_size) +
         " are not read; save it with Gmsh on a 64-bit system");
  binary_ = type == 1;
  begin_data();
  if (binary_) {
    const std::int32_t one = integer("the number that shows the byte order");
    swap_ = one == 0x01000000;
    if (one != 1 && !swap_) fail("the number that shows the byte order is not 1; save the mesh again");
  }
  end_section(section);
}

bool MshSource::next_section(std::string& name) {
  std::string_view word;
  if (!words_.next(word)) return false;
  if (!word.starts_with('$') || word.starts_with("$End") || word.size() < 2)
    fail("a section has to begin here, not " + quoted_word(word) + "; correct the file or save it again");
  name = word.substr(1);
  return true;
}

void MshSource::end_section(const std::string& name) {
  const std::string_view word = words_.word("$End" + name);
  if (word != "$End" + name)
    fail("the section " + quoted_word("$" + name) + " has to end here, with $End" + name + ", not with " +
         quoted_word(word) + "; its number of entries may be wrong");
}

void MshSource::skip_section(const std::string& name) {
  if (!words_.skip_past("$End" + name)) words_.fail_truncated("the end of a section, $End" + name);
}

void MshSource::begin_data() {
  if (!binary_) return;
  words_.rest_of_line();
  words_.end_of_line();
}

std::int32_t MshSource::integer(std::string_view what) {
  if (!binary_) return words_.integer32(what);
  return load<std::int32_t>(words_.raw(4, what), swap_);
}

std::uint64_t MshSource::size(std::string_view what) {
  if (binary_) return load<std::uint64_t>(words_.raw(8, what), swap_);
  const std::int64_t value = words_.integer(what);
  if (value < 0) fail(std::string(what) + " is negative; correct it");
  return static_cast<std::uint64_t>(value);
}

double MshSource::real(std::string_view what) {
  return binary_ ? load<double>(words_.raw(8, what), swap_) : words_.number(what);
}

std::size_t MshSource::count(std::string_view what, std::size_t numbers_each) {
  const std::uint64_t value = size("the number of " + std::string(what));
  words_.check_count(value, what, numbers_each * (binary_ ? 4 : 2));
  return static_cast<std::size_t>(value);
}

}  // namespace multimesh::io
