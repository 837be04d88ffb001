// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/msh_reader.hpp"

#include "adapters/io/msh_content.hpp"

namespace multimesh::io {
namespace {

/// `dimension tag "name"`, as text also in binary files.
void read_physical_names(MshContent& content) {
  WordSource& words = content.in.words();
  for (std::size_t n = words.count("physical names", 6); n > 0; --n) {
    const std::int64_t dimension = words.integer("the dimension of a physical name");
    if (dimension < 0 || dimension > 3) words.fail("the dimension of a physical name must be 0 to 3");
    const std::int32_t tag = words.integer32("the tag of a physical name");
    std::string_view name = trimmed(words.rest_of_line());
    if (name.size() >= 2 && name.starts_with('"') && name.ends_with('"'))
      name = name.substr(1, name.size() - 2);
    content.out.soup().groups.push_back({static_cast<int>(dimension), tag, std::string(name)});
  }
}

using SectionReader = void (*)(MshContent&);

/// Nullptr: the section is left out.
SectionReader reader_of(const std::string& section, int version) {
  const bool new_one = version == 4;
  if (section == "PhysicalNames") return read_physical_names;
  if (section == "Nodes") return new_one ? read_msh4_nodes : read_msh2_nodes;
  if (section == "Elements") return new_one ? read_msh4_elements : read_msh2_elements;
  if (section == "Periodic") return new_one ? read_msh4_periodic : read_msh2_periodic;
  if (section == "Entities" && new_one) return read_msh4_entities;
  if (section == "PartitionedEntities" && new_one) return read_msh4_partitions;
  if (section == "ParametricNodes" && !new_one) return read_msh2_parametric_nodes;
  return nullptr;
}

}  // namespace

SimplexSoup parse_msh(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  MshSource source(bytes, path.string());
  using Where = SimplexBuilder::Where;
  SimplexBuilder builder(path.string(), source.binary() ? Where::element : Where::line, 0);
  MshContent content(source, builder);
  bool has_elements = false;
  for (std::string section; source.next_section(section);) {
    if (const SectionReader read = reader_of(section, source.version())) {
      read(content);
      source.end_section(section);
      has_elements = has_elements || section == "Elements";
    } else {
      source.skip_section(section);
      if (section != "Comments") builder.left_out("$" + section);
    }
  }
  if (!has_elements) source.words().fail_truncated("the section $Elements");
  content.finish();
  return builder.finish(options);
}

}  // namespace multimesh::io
