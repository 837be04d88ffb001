// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Tags that no simplex, group or tag set of any dimension uses: positive, and above all used ones as long as
/// such numbers exist. Cost: linear for the first one.
class UnusedTags {
 public:
  explicit UnusedTags(const SimplexSoup& soup);
  std::int32_t next();

 private:
  std::vector<std::int32_t> used_;  // positive ones, ascending
  std::int64_t last_ = 0;
};

/// The groups of the simplices with that tag: those of its tag set, or the tag alone.
std::vector<std::int32_t> groups_of(const SimplexSoup& soup, int dimension, std::int32_t tag);
/// The tags of simplices in a group: its own, and those of tag sets that contain it.
std::vector<std::int32_t> tags_with(const SimplexSoup& soup, int dimension, std::int32_t group);

/// Adds a named group of one dimension, under the name itself or, if another group has it, with a number.
/// \return the tag of the group; if a group of this name and dimension exists, its tag
std::int32_t named_group(SimplexSoup& soup, int dimension, const std::string& name, UnusedTags& unused);

/// Makes every tag positive, as Gmsh's formats require: readers take 0 for no physical group and refuse files
/// in which only some elements have one, and they take a sign for an orientation. The simplices of one
/// dimension without a tag get a named group of their own, those with a negative tag a new one. \return one
/// sentence per change
std::vector<std::string> make_tags_positive(SimplexSoup& soup);

}  // namespace multimesh::io
