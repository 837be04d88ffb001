// SPDX-License-Identifier: BSD-3-Clause
#include "test/fuzz/read_bytes.hpp"

#include <array>
#include <string>
#include <string_view>

#include "multimesh/error.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/simplex_reader.hpp"

namespace multimesh::test {

bool read_bytes(std::span<const std::uint8_t> bytes) {
  constexpr std::array extensions{"obj", "ply", "stl", "off", "msh", "mesh", "vtk", "vtu"};
  if (bytes.empty()) return false;
  const std::size_t choice = bytes[0] % (2 * extensions.size());
  const std::string path = std::string("fuzz.") + extensions[choice / 2];
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()) + 1, bytes.size() - 1);
  try {
    if (choice % 2 && choice < 8) {
      (void)io::parse_mesh(content, path);
    } else {
      (void)io::parse_simplices(content, path);
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace multimesh::test
