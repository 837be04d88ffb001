// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/vtu_array.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <pugixml.hpp>
#include <type_traits>

#include "adapters/io/base64.hpp"
#include "adapters/io/byte_order.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/vtk_numbers.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

std::string_view text_attribute(const pugi::xml_node& node, const char* name) {
  return node.attribute(name).value();
}

}  // namespace

VtuArrays::VtuArrays(const pugi::xml_node& root, std::string_view xml, std::string_view appended,
                     const std::string& file)
    : xml_(xml), appended_(appended), file_(file) {
  const std::string_view compressor = text_attribute(root, "compressor");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    fail_file(file, "arrays compressed by " + std::string(compressor) +
                        " are not read; save the mesh with zlib compression or none");
  compressed_ = !compressor.empty();
  swap_ = (text_attribute(root, "byte_order") == "BigEndian") != (std::endian::native == std::endian::big);
  wide_header_ = text_attribute(root, "header_type") == "UInt64";
  appended_is_base64_ = text_attribute(root.child("AppendedData"), "encoding") == "base64";
}

std::vector<double> VtuArrays::reals(const pugi::xml_node& array) const {
  return values<double>(array);
}

std::vector<std::int64_t> VtuArrays::integers(const pugi::xml_node& array) const {
  return values<std::int64_t>(array);
}

bool VtuArrays::holds_integers(const pugi::xml_node& array) {
  return text_attribute(array, "type").find("Int") != std::string_view::npos;
}

template <class T>
std::vector<T> VtuArrays::values(const pugi::xml_node& array) const {
  if (text_attribute(array, "format") == "ascii") return text_values<T>(array);
  std::vector<T> values;
  const std::string_view type = text_attribute(array, "type");
  if (!append_numbers(type, bytes(array), swap_, values))
    fail(array, "its bytes are not usable numbers of type " + quoted_word(type) + "; save the mesh again");
  return values;
}

template <class T>
std::vector<T> VtuArrays::text_values(const pugi::xml_node& array) const {
  const pugi::xml_node text = array.first_child();
  const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(text.offset_debug(), 0));
  const auto line = 1 + std::ranges::count(xml_.substr(0, before), '\n');
  WordSource words(text.value(), file_, 0, static_cast<std::size_t>(line));
  std::vector<T> values;
  while (!words.peek().empty()) {
    if constexpr (std::is_integral_v<T>)
      values.push_back(words.integer("an array"));
    else
      values.push_back(words.number("an array"));
  }
  return values;
}

/// Of an array in binary form.
std::string VtuArrays::bytes(const pugi::xml_node& array) const {
  const std::string_view format = text_attribute(array, "format");
  std::string decoded;
  if (format == "binary") {
    if (!decode_base64(array.text().get(), decoded)) fail(array, "it is not base64; save the mesh again");
    return unpacked(array, decoded);
  }
  if (format != "appended")
    fail(array, "its format " + quoted_word(format) + " is not known; save the mesh again");
  const unsigned long long offset = array.attribute("offset").as_ullong();
  if (offset >= appended_.size()) fail(array, "its offset is beyond the end of the file; get the file whole");
  const std::string_view data = appended_.substr(offset);
  if (!appended_is_base64_) return unpacked(array, data);
  // Only the next offset or `<` ends an array; what follows it is harmless, because sizes come first.
  decode_base64(data.substr(0, data.find_first_of("<")), decoded);
  return unpacked(array, decoded);
}

std::string VtuArrays::unpacked(const pugi::xml_node& array, std::string_view data) const {
  if (compressed_) return inflated(array, data);
  const std::uint64_t size = header_number(array, data);
  if (size > data.size()) fail(array, "it is truncated; get the file whole");
  return std::string(data.substr(0, size));
}

/// Blocks of equal size, but for the last, each compressed on its own.
std::string VtuArrays::inflated(const pugi::xml_node& array, std::string_view data) const {
  const std::uint64_t blocks = header_number(array, data);
  const std::uint64_t block_size = header_number(array, data);
  const std::uint64_t last_size = header_number(array, data);
  if (blocks > data.size()) fail(array, "it has more blocks than bytes; save the mesh again");
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t i = 0; i < blocks; ++i) sizes.push_back(header_number(array, data));
  std::string content;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    if (sizes[i] > data.size()) fail(array, "it is truncated; get the file whole");
    const bool is_partial = i + 1 == blocks && last_size != 0;
    content += inflate_zlib(data.substr(0, sizes[i]), is_partial ? last_size : block_size, file_);
    data.remove_prefix(sizes[i]);
  }
  return content;
}

std::uint64_t VtuArrays::header_number(const pugi::xml_node& array, std::string_view& data) const {
  const std::size_t size = wide_header_ ? 8 : 4;
  if (data.size() < size) fail(array, "it is truncated; get the file whole");
  const std::uint64_t value =
      wide_header_ ? load<std::uint64_t>(data, swap_) : load<std::uint32_t>(data, swap_);
  data.remove_prefix(size);
  return value;
}

void VtuArrays::fail(const pugi::xml_node& array, const std::string& message) const {
  std::string name(text_attribute(array, "Name"));
  if (name.empty()) name = array.parent().name();
  fail_file(file_, "array " + quoted_word(name) + ": " + message);
}

}  // namespace multimesh::io
