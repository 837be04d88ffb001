// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/simplex_writer.hpp"

#include <algorithm>
#include <limits>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/polygons_to_simplices.hpp"
#include "adapters/io/second_order.hpp"
#include "adapters/io/simplex_format_writers.hpp"
#include "adapters/io/simplex_names.hpp"
#include "multimesh/error.hpp"
#include "multimesh/io/obj_writer.hpp"

namespace multimesh::io {
namespace {

void check(const SimplexSoup& soup) {
  for (std::size_t k = 0; k < 4; ++k) {
    const SimplexSoup::Block& block = soup.simplices[k];
    if (block.corners.size() != (k + 1) * block.size())
      throw UsageError("a block of simplices has corners and tags of different numbers");
    if (!block.flags.empty() && block.flags.size() != block.size())
      throw UsageError("a block of simplices has flags and tags of different numbers");
    if (std::ranges::any_of(block.corners, [&](auto v) { return v >= soup.points.size(); }))
      throw UsageError("a simplex names a point that is not there");
  }
  for (const SimplexSoup::Periodic& link : soup.periodic) {
    if (link.dimension < 0 || link.dimension > 3 || (!link.affine.empty() && link.affine.size() != 16))
      throw UsageError("a periodic link has no dimension from 0 to 3, or no affine map of 16 numbers");
    for (const auto& [slave, master] : link.points)
      if (slave >= soup.points.size() || master >= soup.points.size())
        throw UsageError("a periodic link names a point that is not there");
  }
  if (!soup.point_tags.empty() && soup.point_tags.size() != soup.points.size())
    throw UsageError("there are points and point tags of different numbers");
}

bool is_surface(const std::string& extension) {
  return extension == ".stl" || extension == ".off" || extension == ".ply" || extension == ".obj";
}

bool any_tag(const SimplexSoup::Block& block) {
  return std::ranges::any_of(block.tags, [](auto tag) { return tag != 0; });
}

/// What no surface format can store.
Lost lost_in_surface(const SimplexSoup& soup, bool has_edges) {
  Lost lost;
  const auto add = [&](std::size_t count, const char* what) {
    if (count != 0) lost.push_back(std::to_string(count) + what);
  };
  add(soup.simplices[3].size(), " tetrahedra");
  if (!has_edges) add(soup.simplices[1].size(), " edges");
  add(soup.simplices[0].size(), " vertices");
  if (any_tag(soup.simplices[2]) || (has_edges && any_tag(soup.simplices[1]))) lost.push_back("tags");
  if (!soup.groups.empty()) lost.push_back("names of groups");
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
  return lost;
}

Lost put_surface(OutputBuffer& out, const SimplexSoup& soup, const std::string& extension, bool binary,
                 const std::string& file) {
  if (extension == ".stl") put_stl(out, soup, binary, file);
  if (extension == ".off") put_off(out, soup);
  if (extension == ".ply") put_ply(out, soup, binary);
  return lost_in_surface(soup, false);
}

/// Warns for formats that have one tag per simplex.
void warn_of_tag_sets(const SimplexSoup& soup, const std::string& file, std::vector<std::string>& warnings) {
  for (const SimplexSoup::TagSet& set : soup.tag_sets) {
    std::string groups;
    for (const std::int32_t tag : set.groups)
      groups.append(groups.empty() ? "" : ", ").append(std::to_string(tag));
    warnings.push_back(file + ": a simplex has one tag there; tag " + std::to_string(set.tag) + " of " +
                       simplex_plurals[static_cast<std::size_t>(set.dimension)] + " stands for the groups " +
                       groups);
  }
}

Lost put_volume(OutputBuffer& out, const SimplexSoup& soup, const std::string& extension,
                const SimplexWriteOptions& options, const std::string& file) {
  Lost lost;
  if (extension == ".mesh") put_medit(out, soup, lost);
  if (extension == ".vtu") put_vtu(out, soup, options.binary, lost);
  if (extension == ".msh" && options.msh_version == MshVersion::v2_2)
    put_msh2(out, soup, options.binary, file, lost);
  if (extension == ".msh" && options.msh_version == MshVersion::v4_1)
    put_msh4(out, soup, options.binary, lost);
  return lost;
}

/// The soup in a form that Gmsh's formats can store; `soup` itself if it already is.
const SimplexSoup& for_gmsh(const SimplexSoup& soup, SimplexSoup& copy, const std::string& file,
                            std::vector<std::string>& warnings) {
  const auto all_positive = [](const auto& block) {
    return std::ranges::all_of(block.tags, [](auto tag) { return tag > 0; });
  };
  if (std::ranges::all_of(soup.simplices, all_positive)) return soup;
  copy = soup;
  for (const std::string& change : make_tags_positive(copy)) warnings.push_back(file + ": " + change);
  return copy;
}

Lost write_as_obj(const std::filesystem::path& path, const SimplexSoup& soup) {
  write_obj(path, to_polygons(soup));
  return lost_in_surface(soup, true);
}

/// Before anything is written.
void check_dimension(const SimplexSoup& soup, const std::string& extension, const std::string& file) {
  if (soup.dimension() < 0) fail_file(file, "there is nothing to write: the mesh has no simplex");
  if (!is_surface(extension)) return;
  const bool has_lines = extension == ".obj" && !soup.simplices[1].tags.empty();
  if (soup.simplices[2].tags.empty() && !has_lines)
    fail_file(file, "the format holds triangles, and the mesh has none; write it as .msh, .mesh or .vtu");
  if (soup.points.size() > std::numeric_limits<std::int32_t>::max())
    fail_file(file, "the format holds at most 2147483647 points; write it as .msh or .vtu");
}

}  // namespace

void check_simplex_output(const std::filesystem::path& path, const SimplexWriteOptions& options) {
  const std::string extension = format_extension(path);
  const bool holds_second_order = extension == ".msh" || extension == ".vtu";
  if ((!holds_second_order && !is_surface(extension) && extension != ".mesh") || path.extension() == ".gz")
    fail_file(path.string(),
              "files of this extension are not written; use .msh, .mesh, .vtu, .obj, .off, .ply or .stl");
  if (options.order != 1 && options.order != 2)
    throw UsageError("simplices are written in first or second order");
  if (options.order == 2 && !holds_second_order)
    fail_file(path.string(), "elements of second order are only written to .msh and .vtu; use one of these");
}

std::vector<std::string> write_simplices(const std::filesystem::path& path, const SimplexSoup& soup,
                                         const SimplexWriteOptions& options) {
  check(soup);
  const std::string file = path.string(), extension = format_extension(path);
  check_simplex_output(path, options);
  check_dimension(soup, extension, file);
  Lost lost;
  std::vector<std::string> warnings;
  if (extension == ".obj") {
    lost = write_as_obj(path, soup);
  } else {
    SimplexSoup copy;
    const bool is_msh = extension == ".msh";
    const SimplexSoup& first_order = is_msh ? for_gmsh(soup, copy, file, warnings) : soup;
    if (options.order == 2) copy = second_order(first_order, file);
    const SimplexSoup& written = options.order == 2 ? copy : first_order;
    if (!is_msh && !is_surface(extension)) warn_of_tag_sets(soup, file, warnings);
    AtomicFile output(path);
    OutputBuffer out(output);
    lost = is_surface(extension) ? put_surface(out, soup, extension, options.binary, file)
                                 : put_volume(out, written, extension, options, file);
    out.flush();
    output.commit();
  }
  if (!soup.periodic.empty() && extension != ".msh") lost.push_back("periodic links");
  for (const std::string& what : lost) warnings.push_back(file + ": " + what + " are not written");
  return warnings;
}

}  // namespace multimesh::io
