// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "adapters/io/byte_order.hpp"

namespace multimesh::io {

/// T from a value of another type. False if it would lose information.
template <class T, class Stored>
bool convert(Stored value, T& result) {
  if constexpr (std::is_integral_v<T> && std::is_floating_point_v<Stored>) {
    if (!(std::abs(value) < Stored(9e15)) || value != std::floor(value)) return false;
  } else if constexpr (std::is_integral_v<T> && sizeof(Stored) == 8 && std::is_unsigned_v<Stored>) {
    if (value > static_cast<Stored>(std::numeric_limits<std::int64_t>::max())) return false;
  }
  result = static_cast<T>(value);
  return true;
}

template <class T, class Stored>
bool append(std::string_view bytes, bool swap, std::vector<T>& values) {
  if (bytes.size() % sizeof(Stored) != 0) return false;
  values.reserve(bytes.size() / sizeof(Stored));
  for (; !bytes.empty(); bytes.remove_prefix(sizeof(Stored))) {
    T value{};
    if (!convert(load<Stored>(bytes, swap), value)) return false;
    values.push_back(value);
  }
  return true;
}

/// Appends binary numbers of one of VTK's types. False for an unknown type, a part of a number at the end,
/// and what T cannot hold exactly, except for the rounding of 64-bit integers to double.
template <class T>
bool append_numbers(std::string_view type, std::string_view bytes, bool swap, std::vector<T>& values) {
  if (type == "Float64") return append<T, double>(bytes, swap, values);
  if (type == "Float32") return append<T, float>(bytes, swap, values);
  if (type == "Int64") return append<T, std::int64_t>(bytes, swap, values);
  if (type == "UInt64") return append<T, std::uint64_t>(bytes, swap, values);
  if (type == "Int32") return append<T, std::int32_t>(bytes, swap, values);
  if (type == "UInt32") return append<T, std::uint32_t>(bytes, swap, values);
  if (type == "Int16") return append<T, std::int16_t>(bytes, swap, values);
  if (type == "UInt16") return append<T, std::uint16_t>(bytes, swap, values);
  if (type == "Int8") return append<T, std::int8_t>(bytes, swap, values);
  if (type == "UInt8") return append<T, std::uint8_t>(bytes, swap, values);
  return false;
}

}  // namespace multimesh::io
