// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Tags that no simplex, group or tag set of any dimension has: positive, and above all of them as long as
/// there are such numbers. Cost: linear for the first one.
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
/// The tags of simplices that are in a group: its own, and those of tag sets with it.
std::vector<std::int32_t> tags_with(const SimplexSoup& soup, int dimension, std::int32_t group);

/// Adds a named group of one dimension, under the name itself or, if another group has it, with a number.
/// \return the tag of the group; that of the group of this name and dimension if there is one
std::int32_t named_group(SimplexSoup& soup, int dimension, const std::string& name, UnusedTags& unused);

/// Makes every tag positive, as Gmsh's formats have to have them: readers take 0 for no physical group and
/// refuse some elements having one and others not, and a sign for an orientation. The simplices of one
/// dimension without a tag get a named group of their own, those with a negative one a new tag.
/// \return a sentence each on what was changed
std::vector<std::string> make_tags_positive(SimplexSoup& soup);

}  // namespace multimesh::io
